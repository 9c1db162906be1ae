"""What the page of a project says of recordings: in words, before all is read, and in columns."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.core.i18n import tr
from app.core.scenes.review_words import COUNTED, decided_text, risk_text
from app.features.project.page import ProjectPage
from app.features.project.presenter import COLUMNS, HINTS, scene_of
from tracking.project import (
    ProjectList,
    ProjectRow,
    RecordingFacts,
    ScannedFile,
    SessionFacts,
    SessionRow,
    Wanted,
)
from tracking.project.fact_reader import frames_done
from tracking.project.readings import Reading
from tracking.tracks import (
    CORRECTED_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Particles,
    Run,
    TrackTable,
    empty,
)

FOLDER = Path("footage")
PETS = SessionFacts(
    tracker="spheroid",
    frames=795,
    fps=7.0,
    people=40,
    rows=5000,
    frames_done=795,
    reviewed_rows=0.08,
    decided=20,
    items_left=17,
    errors_left=9.6,
    errors_low=1,
    errors_high=24,
    errors_at_items=4.0,
    minutes_left=0.2,
)
DRAWN = SessionFacts(
    frames=795, fps=7.0, people=8, rows=500, frames_done=121, reviewed_rows=0.5, hand_made=True
)


def _row(name: str, facts: SessionFacts | None, *, is_here: bool = True) -> ProjectRow:
    session = SessionRow(ScannedFile(FOLDER / f"{name}.h5", ""), facts)
    recording = ScannedFile(FOLDER / name, "") if is_here else None
    known = RecordingFacts(name=name, frames=795, fps=7.0) if is_here else None
    return ProjectRow(name, recording, known, (session,))


def _cells(rows: tuple[ProjectRow, ...], title: str) -> list[str]:
    scene = scene_of(ProjectList(FOLDER, rows), FOLDER, None)
    return [row.cells[COLUMNS.index(title) - 1] for row in scene.rows]


def test_each_column_counts_one_thing() -> None:
    rows = (_row("pets", PETS), _row("drawn", DRAWN))
    assert _cells(rows, "Frames") == ["795", "121 of 795"]
    assert _cells(rows, "Decided") == ["54%", ""]
    assert _cells(rows, "Reviewed") == ["8%", "50%"]
    assert _cells(rows, "Errors left") == ["10 (1 to 24)", ""]
    assert HINTS[COLUMNS.index("Errors left")] == COUNTED
    assert len(HINTS) == len(COLUMNS)


def test_what_is_next_is_told_in_the_words_of_the_window() -> None:
    scene = scene_of(ProjectList(FOLDER, (_row("pets", PETS),)), FOLDER, None)
    assert PETS.errors is not None
    left = "pets: 17 review items left, 0:12 min to watch."
    assert scene.next_text == f"{left} {risk_text(PETS.errors)}"
    tip = scene.rows[0].tip
    assert decided_text(20, 37, 0.08) in tip
    assert risk_text(PETS.errors) == "About 10 identity errors left (likely 1 to 24)."
    assert risk_text(PETS.errors) in tip


@pytest.mark.parametrize("of_session", [False, True])
def test_a_recording_is_missing_only_once_all_recordings_are_read(of_session: bool) -> None:
    file = ScannedFile(FOLDER / "other", "")
    wanted = (Wanted(file, Reading(file.path, of_session)),)
    rows = (_row("lost", PETS, is_here=False), _row("unread", None, is_here=False))
    scene = scene_of(ProjectList(FOLDER, rows, wanted), FOLDER, 0.5)
    gone, seeking = tr("its recording is not in this folder"), tr("looking for its recording")
    assert [row.detail for row in scene.rows] == [gone if of_session else seeking, seeking]


def _table(frames: range) -> TrackTable:
    rows = {name: np.zeros(len(frames), c.dtype) for name, c in empty(CORRECTED_COLUMNS).items()}
    ids = np.ones(len(frames), np.int32)
    return TrackTable({**rows, "frame": np.array(frames, np.int32), "track": ids})


def test_frames_that_a_tracker_went_through_are_done_also_where_nobody_is() -> None:
    none = Particles.none(PARTICLE_COLUMNS)
    run = Run("flow", {}, 0, (10, 50), empty(TRACK_COLUMNS), empty(DETECTION_COLUMNS), none)
    assert frames_done(_table(range(20, 30)), run) == 40
    assert frames_done(_table(range(45, 60)), run) == 50
    assert frames_done(_table(range(20, 30)), None) == 10


def test_columns_are_as_wide_as_their_words_and_as_somebody_made_them(qtbot, theme) -> None:
    page = ProjectPage(lambda _: b"")
    qtbot.addWidget(page)
    page.resize(1280, 400)
    page.show()
    rows = (_row("pets", PETS), _row("drawn", DRAWN))
    page.show_scene(scene_of(ProjectList(FOLDER, rows), FOLDER, None))
    table, state = page.table, COLUMNS.index("State")
    words = table.fontMetrics().horizontalAdvance(tr("Labelled by hand"))
    assert table.columnWidth(state) > words
    assert all(table.columnWidth(at) >= table.sizeHintForColumn(at) for at in range(1, state + 1))
    assert sum(map(table.columnWidth, range(len(COLUMNS)))) == table.viewport().width()
    table.horizontalHeader().resizeSection(state, 300)
    assert sum(map(table.columnWidth, range(len(COLUMNS)))) == table.viewport().width()
    page.show_scene(scene_of(ProjectList(FOLDER, rows[:1]), FOLDER, None))
    assert table.columnWidth(state) == 300
    page.resize(700, 400)
    qtbot.waitUntil(lambda: table.viewport().width() < 700)
    name = table.fontMetrics().horizontalAdvance("tud-campus-real")
    assert table.columnWidth(0) > name
    assert table.horizontalScrollBarPolicy() is Qt.ScrollBarPolicy.ScrollBarAsNeeded
