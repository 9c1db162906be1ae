"""Pictures of spheroids over people in rendered clips, for the report."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.rendered_clips import Clip, folder_of, run_of
from tests.benchmarks.spheroid.spots import TRACKER
from tracking.geometry import View
from tracking.recording import open_recording
from tracking.trackers.spheroid import outlines
from tracking.tracks.run import Run

_COLOURS = ((60, 220, 60), (255, 180, 40), (60, 200, 255), (255, 90, 255))
_WIDTH = 480
_FEW_PARTICLES = 60


def in_a_row(shown: Sequence[tuple[Clip, float]], kept: Path | None = None) -> NDArray[np.uint8]:
    """Pictures of clips at some second, one beside the other; (rows, columns, 3) BGR."""
    return np.concatenate([_one(clip, second, kept) for clip, second in shown], axis=1)


def _one(clip: Clip, second: float, kept: Path | None) -> NDArray[np.uint8]:
    folder = folder_of(clip, kept)
    frame = round(second * clip.fps)
    with open_recording(folder) as recording:
        image = recording.read(frame).left.copy()
        view = recording.view
    assert view is not None
    drawn = _drawn(image, view, run_of(folder, TRACKER), frame)
    height = round(_WIDTH * drawn.shape[0] / drawn.shape[1])
    return np.asarray(cv2.resize(drawn, (_WIDTH, height), interpolation=cv2.INTER_AREA), np.uint8)


def _drawn(image: NDArray[np.uint8], view: View, run: Run, frame: int) -> NDArray[np.uint8]:
    """Hypotheses thin, the track's own spheroid bold, with its id."""
    particles = {name: np.asarray(column) for name, column in run.particles.of_frame(frame).items()}
    tall_m = _heights(run, frame)
    for row in np.flatnonzero(run.tracks["frame"] == frame):
        track = int(run.tracks["track"][row])
        colour = _COLOURS[track % len(_COLOURS)]
        own = np.flatnonzero(particles["track"] == track)[:_FEW_PARTICLES]
        places = np.column_stack((particles["x"][own], particles["y"][own]))
        _outline(image, outlines(view, places, tall_m[track]), colour, 1)
        place = np.array([[run.tracks["x"][row], run.tracks["y"][row]]])
        _outline(image, outlines(view, place, tall_m[track]), (255, 255, 255), 2)
    return image


def _heights(run: Run, frame: int) -> dict[int, float]:
    now = run.signals["frame"] == frame
    return dict(
        zip(run.signals["track"][now].tolist(), run.signals["height_m"][now].tolist(), strict=True)
    )


def _outline(
    image: NDArray[np.uint8],
    polygons: NDArray[np.float64],
    colour: tuple[int, int, int],
    thickness: int,
) -> None:
    known = polygons[np.isfinite(polygons).all(axis=(1, 2))]
    points = [np.rint(16 * polygon).astype(np.int32) for polygon in known]
    cv2.polylines(image, points, True, colour, thickness, cv2.LINE_AA, shift=4)
