"""Pictures of tracked people, for the pages and to look at."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.runner import Case, fresh_runs
from tracking.recording import open_recording
from tracking.trackers.spheroid import outlines
from tracking.tracks import Columns
from tracking.tracks.run import Run

Picture = NDArray[np.uint8]
Colour = tuple[int, int, int]

WHITE = (255, 255, 255)
_TRACKS: Sequence[Colour] = ((60, 220, 60), (255, 180, 40), (60, 200, 255), (255, 90, 255))
_PARTS: Sequence[Colour] = ((0, 255, 255), (80, 255, 80), (255, 160, 40))
"""Of head, torso, hip-leg."""
_LOST = (40, 40, 255)
_WIDTH, _FEW_PARTICLES = 480, 60


def side_by_side(pictures: Sequence[Picture]) -> Picture:
    """Pictures of one height in a row."""
    return np.concatenate(pictures, axis=1)


def write(image: Picture, text: str, place: tuple[int, int], colour: Colour = WHITE) -> None:
    """Text on a dark plate; its left bottom corner is at `place`, px."""
    font, size = cv2.FONT_HERSHEY_SIMPLEX, 0.5
    (width, height), below = cv2.getTextSize(text, font, size, 1)
    left, bottom = place
    low, high = (left - 2, bottom - height - 2), (left + width + 1, bottom + below)
    cv2.rectangle(image, low, high, (0, 0, 0), -1)
    cv2.putText(image, text, place, font, size, colour, 1, cv2.LINE_AA)


def fresh_run(folder: Path, case: Case) -> Run:
    """A run tracked now, with all that is not kept of others: particles, verdicts in force."""
    ((_, fresh),) = fresh_runs(folder, [case])
    return fresh.run


def spheroids(clip: Clip, second: float, kept: Path | None = None) -> Picture:
    """People at some second: hypotheses thin, each track's own spheroid bold."""
    folder, frame = folder_of(clip, kept), round(second * clip.fps)
    with open_recording(folder) as recording:
        image, view = recording.read(frame).left.copy(), recording.view
    assert view is not None
    run = fresh_run(folder, Case("spheroid"))
    particles = {name: np.asarray(column) for name, column in run.particles.of_frame(frame).items()}
    tall_m = _at(run.signals, frame, "height_m")
    for track, x, y in zip(*_at_rows(run.tracks, frame, ("track", "x", "y")), strict=True):
        own = np.flatnonzero(particles["track"] == track)[:_FEW_PARTICLES]
        places = np.column_stack((particles["x"][own], particles["y"][own]))
        _outline(image, outlines(view, places, tall_m[track]), _TRACKS[track % len(_TRACKS)], 1)
        _outline(image, outlines(view, np.array([[x, y]]), tall_m[track]), WHITE, 2)
    height = round(_WIDTH * image.shape[0] / image.shape[1])
    return np.asarray(cv2.resize(image, (_WIDTH, height), interpolation=cv2.INTER_AREA), np.uint8)


def _at_rows(columns: Columns, frame: int, names: Sequence[str]) -> list[list[float]]:
    now = columns["frame"] == frame
    return [columns[name][now].tolist() for name in names]


def _at(columns: Columns, frame: int, name: str) -> dict[int, float]:
    """A column's values in a frame, by track."""
    return dict(zip(*_at_rows(columns, frame, ("track", name)), strict=True))


def _outline(image: Picture, polygons: NDArray[np.float64], colour: Colour, thickness: int) -> None:
    known = polygons[np.isfinite(polygons).all(axis=(1, 2))]
    points = [np.rint(16 * polygon).astype(np.int32) for polygon in known]
    cv2.polylines(image, points, True, colour, thickness, cv2.LINE_AA, shift=4)


def body_parts(
    folder: Path, cases: Sequence[Case], frames: Sequence[int], rows: int | None = None
) -> Picture:
    """A row of pictures a frame, a column a tracker; `rows`: so many from the top are shown.

    They are drawn of fresh runs: a kept one that acts on no verdict has those of any detector.
    """
    with open_recording(folder) as recording:
        images = [recording.read(frame).left[:rows] for frame in frames]
    columns = []
    for case in cases:
        parts = fresh_run(folder, case).parts
        drawn = [_with_parts(image, parts, at) for image, at in zip(images, frames, strict=True)]
        for image in drawn:
            write(image, str(case), (8, 22))
        columns.append(np.concatenate(drawn))
    return side_by_side(columns)


def _with_parts(image: Picture, parts: Columns, frame: int) -> Picture:
    """The picture with everybody's rectangles; thin where occluded, red where judged lost."""
    shown = image.copy()
    for row in np.flatnonzero(parts["frame"] == frame):
        middle = np.array((parts["cx"][row], parts["cy"][row]))
        half = np.array((parts["width"][row], parts["height"][row])) / 2
        low, high = (np.rint(at).astype(int).tolist() for at in (middle - half, middle + half))
        colour = _LOST if parts["failed"][row] else _PARTS[parts["part"][row]]
        cv2.rectangle(shown, low, high, colour, 1 if parts["occluded"][row] else 2)
        if parts["part"][row] == 0:
            write(shown, str(parts["track"][row]), (low[0], low[1] - 5))
    return shown
