"""Occluders and counting lines that are drawn in a set-up, as labels of a session."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from app.core.document.document_loader import session_by_hand
from app.features.setup.scene import SetupState
from tracking.editing import plan_lines, plan_occluders
from tracking.geometry import View
from tracking.recording import open_recording
from tracking.tracks import CountingLine, Labels

_FARTHEST_M = 100.0
"""Ends of lines that seem farther off lie near the horizon: such a line stays in the picture."""


def with_labels(state: SetupState, labels: Labels, view: View | None) -> SetupState:
    """A set-up that begins with what is drawn in a session; lines on the floor as they are seen."""
    seen = [_in_picture(line, view) for line in labels.lines]
    lines = tuple(line for line in seen if line is not None)
    return replace(state, occluders=labels.occluders, lines=lines)


def check_drawn(state: SetupState) -> None:
    """Refuse what can be no label, before anything is written. Raises EditError."""
    _check(Labels(occluders=tuple(sorted(state.occluders)), lines=tuple(sorted(state.lines))))


def _check(labels: Labels) -> None:
    if labels.occluders:
        plan_occluders(Labels(), labels.occluders)
    if labels.lines:
        plan_lines(Labels(), labels.lines)


def keep_drawn(folder: Path, state: SetupState) -> Path:
    """Keep what is drawn in a new session of a recording; its path; slow.

    Lines lie on the floor where that is known, else in the picture.

    Raises:
        RecordingError, OutputError, EditError, OSError: it cannot be opened, or kept.
    """
    with open_recording(folder) as recording:
        lines = [_on_floor(line, recording.view) for line in state.lines]
        labels = Labels(occluders=tuple(sorted(state.occluders)), lines=tuple(sorted(lines)))
        _check(labels)
        session = session_by_hand(recording, labels)
        assert session.path is not None, "it is on disk from its first moment"
        session.close()
        return session.path


def _on_floor(line: CountingLine, view: View | None) -> CountingLine:
    if view is None:
        return line
    places = view.floor_from_pixel(np.array([line.start, line.end]))
    if not np.isfinite(places).all() or np.abs(places).max() > _FARTHEST_M:
        return line
    start, end = ((round(float(x), 3), round(float(y), 3)) for x, y in places)
    return CountingLine(line.name, start, end)


def _in_picture(line: CountingLine, view: View | None) -> CountingLine | None:
    """None where it is out of the camera's sight."""
    if line.in_picture:
        return line
    if view is None:
        return None
    ends = np.array([(*line.start, 0.0), (*line.end, 0.0)])
    pixels = view.pixel_from_world(ends)
    if not np.isfinite(pixels).all():
        return None
    start, end = ((round(float(u), 1), round(float(v), 1)) for u, v in pixels)
    return CountingLine(line.name, start, end, in_picture=True)
