"""Pictures of people in rendered clips just before, while and after their track went wrong."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from tests.benchmarks.pages import Figures
from tests.benchmarks.pictures import WHITE, Picture, side_by_side, write
from tests.benchmarks.runner import run_of
from tests.benchmarks.stereo.clips import OURS
from tests.benchmarks.stereo.reasons import NEVER
from tests.benchmarks.stereo.truth import Floats, Truth, truth_of
from tracking.recording import open_recording
from tracking.tracks import Columns

_HAD, _GOT, _OTHERS = (60, 220, 60), (255, 90, 255), (190, 190, 190)
_SIZE = (360, 270)
_MARGIN_S = 0.5
_ROOM = 2.0
"""Times the height of the person's box: what of the picture is shown."""


def typical(people: Mapping[str, Sequence[Figures]], most: int = 2) -> list[Figures]:
    """One person each of the most frequent kinds of failure, those who were ever found.

    Of two people whose tracks were mixed up with each other, one is shown.
    """
    found = [row for rows in people.values() for row in rows if row["what"] != NEVER]
    often = Counter((row["what"], row["where"]) for row in found)
    shown: list[Figures] = []
    for kind, _ in often.most_common():
        of_kind = [row for row in found if (row["what"], row["where"]) == kind]
        new = [row for row in of_kind if not any(_same(row, one) for one in shown)]
        shown += new[:1]
    return shown[:most]


def _same(one: Figures, other: Figures) -> bool:
    """Whether two people were mixed up with each other."""
    return bool(one["clip"] == other["clip"] and one["other"] == other["person"])


def strip(shown: Sequence[Figures], folders: Mapping[str, Path]) -> Picture:
    """A row of three pictures a person: half a second before, when it shows, half a second on."""
    return np.concatenate([_row(one, folders[one["clip"]]) for one in shown])


def _row(one: Figures, folder: Path) -> Picture:
    truth = truth_of(folder)
    tracks = run_of(folder, OURS).tracks
    margin = round(_MARGIN_S * truth.fps)
    with open_recording(folder) as recording:
        last = recording.frame_count - 1
        wanted = (one["last"] - margin, (one["last"] + one["frame"]) // 2, one["frame"] + margin)
        frames = [min(max(frame, 0), last) for frame in wanted]
        images = [recording.read(frame).left.copy() for frame in frames]
    shown = [
        _drawn(image, _Window.of(truth, one, frame), truth, tracks, one, frame)
        for image, frame in zip(images, frames, strict=True)
    ]
    who = f"{one['clip']}, person {one['person']}, frame {frames[0]}"
    write(shown[0], who, (8, _SIZE[1] - 10))
    return side_by_side(shown)


@dataclass(frozen=True, slots=True)
class _Window:
    """The part of a picture that is shown, at one size: left, top, height in px."""

    left: int
    top: int
    height: int

    @classmethod
    def of(cls, truth: Truth, one: Figures, frame: int) -> _Window:
        """Round the person, as large as fits into the picture."""
        own = np.flatnonzero(truth.person == one["person"])
        left, top, width, height = truth.box[own[np.argmin(np.abs(truth.frame[own] - frame))]]
        columns, rows = truth.size
        shown = min(rows, columns * _SIZE[1] // _SIZE[0], round(_ROOM * height))
        return cls(
            int(np.clip(left + width / 2 - cls._width(shown) / 2, 0, columns - cls._width(shown))),
            int(np.clip(top + height / 2 - shown / 2, 0, rows - shown)),
            shown,
        )

    @staticmethod
    def _width(height: int) -> int:
        return height * _SIZE[0] // _SIZE[1]

    def cut(self, image: Picture) -> Picture:
        """What is shown of a picture."""
        right, bottom = self.left + self._width(self.height), self.top + self.height
        part = image[self.top : bottom, self.left : right]
        way = cv2.INTER_AREA if self.height > _SIZE[1] else cv2.INTER_CUBIC
        return np.asarray(cv2.resize(part, _SIZE, interpolation=way), np.uint8)

    def corners(self, box: Floats) -> tuple[tuple[int, int], tuple[int, int]]:
        """Top left and bottom right of a box where it is shown."""
        scale = _SIZE[1] / self.height
        low = np.rint((box[:2] - (self.left, self.top)) * scale).astype(int).tolist()
        high = np.rint((box[:2] + box[2:] - (self.left, self.top)) * scale).astype(int).tolist()
        return (low[0], low[1]), (high[0], high[1])


def _drawn(
    image: Picture, window: _Window, truth: Truth, tracks: Columns, one: Figures, frame: int
) -> Picture:
    """The person's true box, the tracks it had and got with their ids, and all others thin."""
    shown = window.cut(image)
    had, got = one["tracks"]
    now = tracks["frame"] == frame
    for row in np.flatnonzero(now & ~np.isin(tracks["track"], (had, got))):
        cv2.rectangle(shown, *window.corners(_box(tracks, int(row))), _OTHERS, 1)
    for row in truth.of(one["person"], frame, frame):
        cv2.rectangle(shown, *window.corners(truth.box[row]), WHITE, 2)
    for track, colour in ((got, _GOT), (had, _HAD)):
        for row in np.flatnonzero(now & (tracks["track"] == track)):
            low, high = window.corners(_box(tracks, int(row)))
            cv2.rectangle(shown, low, high, colour, 2)
            # Inside at the feet, each on its own side: boxes of both may be the same.
            left = max(low[0], 0) + 4 if track == had else min(high[0], _SIZE[0]) - 26
            write(shown, str(track), (left, min(high[1], _SIZE[1] - 30) - 6), colour)
    write(shown, f"frame {frame}", (8, _SIZE[1] - 10))
    return shown


def _box(tracks: Columns, row: int) -> Floats:
    return np.array([tracks[name][row] for name in ("left", "top", "width", "height")])
