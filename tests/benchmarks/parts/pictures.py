"""Pictures of body parts being tracked: of rendered clips for the report, of footage to look at."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.pages import save_jpeg
from tests.benchmarks.parts.clips import Clip, folder_of
from tests.benchmarks.parts.real import folders_in
from tests.benchmarks.parts.tracker_runs import ADJUSTED, PLAIN, Variant, fresh_run
from tracking.recording import open_recording
from tracking.tracks import Columns

_COLOURS = ((0, 255, 255), (80, 255, 80), (255, 160, 40))  # head, torso, hip-leg
_LOST = (40, 40, 255)
_SHOWN_ROWS = 360  # nobody stands farther down
_SHARES = (0.3, 0.5, 0.7)
"""Of a real recording's length: which frames are shown."""


def side_by_side(
    clip: Clip, variants: Sequence[Variant], frames: Sequence[int], kept: Path | None = None
) -> NDArray[np.uint8]:
    """A row of pictures a frame, a column a tracker; (rows, columns, 3) BGR."""
    return _side_by_side(folder_of(clip, kept), variants, frames, _SHOWN_ROWS)


def of_real_footage(data: Path | None, shown: Path) -> list[Path]:
    """Pictures of the real recordings that are there, with parts drawn, into a folder.

    They show people in footage of others, so they are for looking at and not for the repository.
    """
    shown.mkdir(parents=True, exist_ok=True)
    written = []
    for folder in folders_in(data):
        with open_recording(folder) as recording:
            frames = [round(recording.frame_count * share) for share in _SHARES]
        written.append(shown / f"{folder.name}.jpg")
        save_jpeg(written[-1], _side_by_side(folder, (ADJUSTED, PLAIN), frames, None))
    return written


def _side_by_side(
    folder: Path, variants: Sequence[Variant], frames: Sequence[int], rows: int | None
) -> NDArray[np.uint8]:
    with open_recording(folder) as recording:
        images = [recording.read(frame).left[:rows] for frame in frames]
    columns = []
    for variant in variants:
        # Not a kept run: one that acts on no verdict keeps those of any detector.
        parts = fresh_run(folder, variant).parts
        drawn = [_drawn(image, parts, at) for image, at in zip(images, frames, strict=True)]
        for image in drawn:
            _write(image, variant.name, (8, 22))
        columns.append(np.concatenate(drawn))
    return np.concatenate(columns, axis=1)


def _drawn(image: NDArray[np.uint8], parts: Columns, frame: int) -> NDArray[np.uint8]:
    """The picture with everybody's rectangles; thin where occluded, red where judged lost."""
    shown = image.copy()
    for row in np.flatnonzero(parts["frame"] == frame):
        middle = np.array((parts["cx"][row], parts["cy"][row]))
        half = np.array((parts["width"][row], parts["height"][row])) / 2
        low, high = (
            np.rint(corner).astype(int).tolist() for corner in (middle - half, middle + half)
        )
        colour = _LOST if parts["failed"][row] else _COLOURS[parts["part"][row]]
        cv2.rectangle(shown, low, high, colour, 1 if parts["occluded"][row] else 2)
        if parts["part"][row] == 0:
            _write(shown, str(parts["track"][row]), (low[0], low[1] - 5))
    return shown


def _write(image: NDArray[np.uint8], text: str, place: tuple[int, int]) -> None:
    font, size, ink = cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 255, 255)
    (width, height), below = cv2.getTextSize(text, font, size, 1)
    left, bottom = place
    cv2.rectangle(image, (left - 2, bottom - height - 2), (left + width, bottom + below), 0, -1)
    cv2.putText(image, text, place, font, size, ink, 1)
