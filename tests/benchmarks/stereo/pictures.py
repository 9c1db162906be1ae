"""Pictures of people in rendered clips just before, while and after their track went wrong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.pages import Figures
from tests.benchmarks.stereo.columns import OURS
from tests.benchmarks.stereo.reasons import NEVER
from tests.benchmarks.stereo.trackers import runs_over
from tests.benchmarks.stereo.truth import Floats, Truth, truth_of
from tracking.recording import open_recording
from tracking.tracks import Columns

Picture = NDArray[np.uint8]

_COLOURS = ((60, 220, 60), (255, 180, 40), (60, 200, 255), (255, 90, 255), (90, 90, 255))
_TRUE = (255, 255, 255)
_SIZE = (320, 240)
_MARGIN_S = 0.5
_ROOM = 2.0
"""Times the height of the person's box: what of the picture is shown."""


def typical(people: Mapping[str, Sequence[Figures]], most: int = 2) -> list[Figures]:
    """One person each of the most frequent kinds of failure, those who were ever found."""
    found = [row for rows in people.values() for row in rows if row["what"] != NEVER]
    often = Counter((row["what"], row["where"]) for row in found)
    kinds = [kind for kind, _ in often.most_common(most)]
    return [next(row for row in found if (row["what"], row["where"]) == kind) for kind in kinds]


def strip(shown: Sequence[Figures], folders: Mapping[str, Path]) -> Picture:
    """A row of three pictures a person: half a second before, when it shows, half a second on."""
    return np.concatenate([_row(one, folders[one["clip"]]) for one in shown])


def caption(one: Figures) -> str:
    """What the row of one person shows."""
    other = f" with person {one['other']}" if one["other"] else ""
    return (
        f"{one['clip']}, person {one['person']}: {one['what']}{other}, {one['where']}, frames "
        f"{one['last']} to {one['frame']}."
    )


def _row(one: Figures, folder: Path) -> Picture:
    truth = truth_of(folder)
    tracks = runs_over(folder, [OURS])[OURS].tracks
    margin = round(_MARGIN_S * truth.fps)
    with open_recording(folder) as recording:
        last = recording.frame_count - 1
        wanted = (one["last"] - margin, (one["last"] + one["frame"]) // 2, one["frame"] + margin)
        frames = [min(max(frame, 0), last) for frame in wanted]
        images = [recording.read(frame).left.copy() for frame in frames]
    shown = [
        _cut(_drawn(image, truth, tracks, frame, one["person"]), _focus(truth, one, frame))
        for image, frame in zip(images, frames, strict=True)
    ]
    return np.concatenate(shown, axis=1)


def _focus(truth: Truth, one: Figures, frame: int) -> Floats:
    """(3,) centre and height of the person's box in the frame nearest to that one."""
    own = np.flatnonzero(truth.person == one["person"])
    row = own[np.argmin(np.abs(truth.frame[own] - frame))]
    left, top, width, height = truth.box[row]
    return np.array([left + width / 2, top + height / 2, height])


def _drawn(image: Picture, truth: Truth, tracks: Columns, frame: int, person: int) -> Picture:
    for row in truth.of(person, frame, frame):
        _box(image, truth.box[row], _TRUE)
    for row in np.flatnonzero(tracks["frame"] == frame):
        track = int(tracks["track"][row])
        box = np.array([tracks[name][row] for name in ("left", "top", "width", "height")])
        colour = _COLOURS[track % len(_COLOURS)]
        _box(image, box, colour)
        corner = (int(box[0]) + 3, max(12, int(box[1]) + 13))
        cv2.putText(image, str(track), corner, cv2.FONT_HERSHEY_SIMPLEX, 0.5, colour, 1)
    return image


def _box(image: Picture, box: Floats, colour: tuple[int, int, int]) -> None:
    left, top, width, height = np.rint(box).astype(int).tolist()
    cv2.rectangle(image, (left, top), (left + width, top + height), colour, 1)


def _cut(image: Picture, focus: Floats) -> Picture:
    """The part round the person, as large as fits into the picture, at one size."""
    rows, columns = image.shape[:2]
    height = min(rows, columns * _SIZE[1] // _SIZE[0], round(_ROOM * focus[2]))
    width = height * _SIZE[0] // _SIZE[1]
    left = int(np.clip(focus[0] - width / 2, 0, columns - width))
    top = int(np.clip(focus[1] - height / 2, 0, rows - height))
    part = image[top : top + height, left : left + width]
    return np.asarray(cv2.resize(part, _SIZE, interpolation=cv2.INTER_AREA), np.uint8)
