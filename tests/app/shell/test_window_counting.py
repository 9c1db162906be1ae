"""Counting in the real window: counters, panel, plots, table, export, flow map."""

from __future__ import annotations

import csv

import numpy as np
import pytest
from correcting_window import open_for_correcting
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QFont, QFontMetrics, QGuiApplication
from PySide6.QtTest import QTest

from app.core.document.track_sources import SHOWN
from app.core.look.icons import IconButton
from app.features.counting.controller import CountController
from app.features.counting.panel import CountingPanel
from tracking.counting import occupancy, passages
from tracking.editing import plan_delete_tracks, plan_lines, plan_regions
from tracking.trackers import StepResult
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    CountingLine,
    Region,
    between,
    empty,
)

GATE = CountingLine("gate", (1.0, -1.0), (1.2, 9.0))
SCREEN = CountingLine("screen", (0.0, 100.0), (320.0, 99.0), in_picture=True)
HALL = Region("hall", ((-3.0, 2.0), (3.0, 2.0), (3.0, 6.0), (-3.0, 6.0)))
LEFT = Qt.MouseButton.LeftButton
Key = Qt.Key


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


@pytest.fixture
def counted(controller, qtbot):
    """Draws lines and regions, and waits until they are counted."""

    def draw(lines=(GATE, SCREEN), regions=(HALL,)):
        document = controller.document
        document.apply(plan_lines(document.session.labels, lines))
        if regions:
            document.apply(plan_regions(document.session.labels, regions))
        controller.draw()
        at_rest(controller, qtbot)
        return controller

    return draw


def at_rest(controller, qtbot) -> None:
    counting = controller.of(CountController)
    qtbot.waitUntil(lambda: counting.counts is not None and not counting._search.busy)
    qtbot.wait(1)


def go(controller, qtbot, frame: int) -> None:
    controller.playback.go(frame)
    qtbot.waitUntil(lambda: controller.playback.number == frame)
    qtbot.wait(1)


def cells(window) -> list[list[str]]:
    tallies = window.workspace.of(CountingPanel).tallies
    return [
        [tallies.item(row, column).text() for column in range(tallies.columnCount())]
        for row in range(tallies.rowCount())
    ]


def said_on(view) -> dict[str, str]:
    return {one.name: one.said for one in view._labels.outlines}


def test_counters_stand_at_lines_and_regions_for_the_frame_shown(window, counted, qtbot):
    controller = counted()
    columns = controller.document.session.tracks.columns()
    fps = controller.document.recording.fps
    found = passages(columns, fps, [GATE, SCREEN])
    assert len(found.of_line(0)) >= 2
    for frame in (
        0,
        int(np.median(found.of_line(0).frame)),
        controller.document.recording.frame_count - 1,
    ):
        go(controller, qtbot, frame)
        told = said_on(window.workspace.left)
        for number, line in enumerate((GATE, SCREEN)):
            part = found.of_line(number)
            ahead, back = part.rows(part.frame <= frame).totals
            assert told[line.name] == f"{ahead} forward, {back} backward"
        assert said_on(window.workspace.overhead).keys() == {"gate", "hall", "screen"}
    here = columns["frame"] == frame
    within = (np.abs(columns["x"]) < 3) & (columns["y"] > 2) & (columns["y"] < 6) & here
    people = np.count_nonzero(within)
    assert said_on(window.workspace.overhead)["hall"] == f"{people} inside, {people / 24:.2f}/m²"


def test_counters_can_be_turned_off(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counts")
    assert set(said_on(window.workspace.overhead).values()) == {""}
    window.run_command("view.counts")
    assert said_on(window.workspace.overhead)["gate"] != ""
    assert controller.view_options.counts


def test_the_panel_says_what_to_do_where_nothing_is_drawn(window, controller):
    panel = window.workspace.of(CountingPanel)
    assert not panel.isVisible()
    window.run_command("view.counting")
    assert panel.isVisible()
    assert "Draw a counting line" in panel.plot._scene.message
    assert not panel._save.isEnabled()
    panel.findChild(IconButton).click()
    assert not panel.isVisible()


def test_the_panel_lists_what_is_counted_and_plots_what_is_picked(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counting")
    assert [row[0] for row in cells(window)] == ["gate", "screen", "hall"]
    panel = window.workspace.of(CountingPanel)
    assert [plot.name for plot in panel.plot._scene.plots] == ["So far", "Per 0.5 s"]
    ahead, back = controller.of(CountController).counts.lines[0].totals
    curves = panel.plot._scene.plots[0].curves
    assert (curves[0].values[-1], curves[1].values[-1]) == (ahead, back)
    panel.tallies.setCurrentCell(2, 0)
    assert [plot.unit for plot in panel.plot._scene.plots] == ["", "1/m²", "m/s"]
    assert (
        panel.plot._scene.plots[0].curves[0].values.max()
        == controller.of(CountController).counts.regions[0].people.max()
    )


def test_a_click_into_the_plots_goes_there(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counting")
    plot = window.workspace.of(CountingPanel).plot
    qtbot.waitUntil(lambda: plot.width() > 100)
    x = plot.axis.x_of(31.5)
    frame = plot.axis.frame_at(round(x))  # the plot may be laid out anew once it is clicked
    QTest.mouseClick(plot, LEFT, pos=QPoint(round(x), plot.height() // 2))
    qtbot.waitUntil(lambda: controller.playback.number == frame)
    assert abs(controller.playback.number - 31) <= 1


def test_an_edit_is_counted_anew_and_a_run_stays_as_it_was(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counting")
    document, before = controller.document, controller.of(CountController).counts
    most = sum(before.lines[0].totals)
    gone = sorted(set(before.passages.of_line(0).track.tolist()))
    controller.document.apply(plan_delete_tracks(document.session.tracks, gone))
    controller.draw()
    qtbot.waitUntil(lambda: controller.of(CountController).counts is not before)
    at_rest(controller, qtbot)
    assert controller.of(CountController).counts.lines[0].totals == (0, 0)
    panel = window.workspace.of(CountingPanel)
    assert panel._track_sources.count() == 2
    panel.track_source_chosen.emit(1)
    presenter = controller.of(CountController).presenter
    qtbot.waitUntil(lambda: presenter.counted.subject.track_source == 0)
    assert sum(controller.of(CountController).counts.lines[0].totals) == most
    panel.track_source_chosen.emit(0)
    qtbot.waitUntil(lambda: presenter.counted.subject.track_source == SHOWN)


def test_the_newest_of_several_changes_wins(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counting")
    panel = window.workspace.of(CountingPanel)
    for step_s in (0.25, 1.0, 2.0):
        panel.step_chosen.emit(step_s)
    panel.jitter_chosen.emit(0.1)
    qtbot.waitUntil(lambda: controller.of(CountController).counts.settings.step_s == 2.0)
    at_rest(controller, qtbot)
    assert (
        controller.of(CountController).counts.settings.step_s,
        controller.of(CountController).counts.settings.jitter_m,
    ) == (
        2.0,
        0.1,
    )
    assert panel._step.value() == 2.0


def test_every_step_stands_in_the_table_and_is_copied(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counting")
    panel = window.workspace.of(CountingPanel)
    panel._as_table.click()
    table = panel.table
    assert table.isVisible()
    counts = controller.of(CountController).counts
    assert table.steps.rowCount() == len(counts.steps)
    headings = [table.steps.headerData(column, Qt.Orientation.Horizontal) for column in range(8)]
    assert headings == [
        "Time",
        "gate\nforward",
        "gate\nbackward",
        "screen\nforward",
        "screen\nbackward",
        "hall\npeople",
        "hall\npeople/m²",
        "hall\nm/s",
    ]
    panel._copy.click()
    lines = QGuiApplication.clipboard().text().splitlines()
    assert len(lines) == 1 + len(counts.steps)
    step = int(counts.regions[0].people.argmax())
    row = lines[1 + step].split("\t")
    assert row[5] == str(counts.regions[0].people[step])
    bold = QFont(table.font())
    bold.setBold(True)
    last = table.steps.text(table.steps.rowCount() - 1, 0)
    assert table.columnWidth(0) > QFontMetrics(bold).horizontalAdvance(last) + 4
    table.selectRow(3)
    QTest.keyClick(table, Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert len(QGuiApplication.clipboard().text().splitlines()) == 2


def test_a_click_on_a_step_goes_there(window, counted, qtbot):
    controller = counted()
    window.run_command("view.counting")
    panel = window.workspace.of(CountingPanel)
    panel._as_table.click()
    panel.table.clicked.emit(panel.table.steps.index(4, 1))
    expected = int(controller.of(CountController).counts.steps.frame[4])
    qtbot.waitUntil(lambda: controller.playback.number == expected)
    font = panel.table.steps.data(panel.table.steps.index(4, 0), Qt.ItemDataRole.FontRole)
    assert font.bold()


def test_counts_are_exported_as_csv(window, counted, qtbot, tmp_path):
    controller = counted()
    out = tmp_path / "counts.csv"
    window.files.exporting.counts_to(out)
    qtbot.waitUntil(lambda: out.exists() and not window.work.busy)
    with out.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    columns = controller.document.session.tracks.columns()
    frames, fps = controller.document.recording.frame_count, controller.document.recording.fps
    (hall,) = occupancy(columns, fps, [HALL], frames)
    people = [int(row["people"]) for row in rows if row["name"] == "hall"]
    assert people == hall.people.tolist()


def test_what_is_exported_is_of_the_tracks_of_now(window, counted, qtbot, tmp_path):
    controller = counted(lines=(GATE,), regions=())
    window.run_command("view.counts")  # nobody asks for counts from now on
    document, out = controller.document, tmp_path / "counts.csv"
    gone = list(document.session.tracks.track_ids)
    document.apply(plan_delete_tracks(document.session.tracks, gone))
    controller.draw()
    window.files.exporting.counts_to(out)
    qtbot.waitUntil(lambda: out.exists() and not window.work.busy)
    with out.open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert {row["forward"] for row in rows} == {row["backward"] for row in rows} == {"0"}


def test_f6_reaches_the_counting(window, counted):
    counted()
    window.run_command("view.counting")
    reached = []
    for _ in range(10):
        window.run_command("view.next_pane")
        reached.append(window.workspace._ring.pane)
    assert window.workspace.of(CountingPanel) in reached
    assert window.workspace.timeline in reached


def test_who_trembles_at_a_line_in_the_picture_is_left_out_by_choice(window, counted, qtbot):
    controller = counted(lines=(SCREEN,), regions=())
    window.run_command("view.counting")
    panel = window.workspace.of(CountingPanel)
    assert panel._jitter_px.isVisible()
    assert not panel._jitter.isVisible()
    panel._jitter_px.setValue(12.0)
    qtbot.waitUntil(lambda: controller.of(CountController).counts.settings.jitter_px == 12.0)


def test_exporting_nothing_is_told(window, controller, qtbot):
    window.run_command("file.export_counts")
    assert "Nothing is counted" in window.statusBar().currentMessage()


def test_a_line_is_drawn_in_the_picture_and_counts_feet(window, controller, press, qtbot):
    press(Key.Key_3, Qt.KeyboardModifier.AltModifier)
    layer = controller.labelling._shapes.on_picture
    for at in (QPointF(20.0, 120.0), QPointF(300.0, 120.0)):
        place = layer.canvas.viewport.point(at.x(), at.y()).toPoint()
        QTest.mouseClick(layer, LEFT, pos=place)
    (line,) = controller.document.session.labels.lines
    assert line.in_picture
    scale = layer.canvas.viewport.scale
    assert line.start == pytest.approx((20.0, 120.0), abs=1.0 / scale)
    (outline,) = window.workspace.left._labels.outlines
    tail, tip = outline.arrow
    assert tip[1] > tail[1]  # to the right of its way is down the picture
    (below,) = window.workspace.overhead._labels.outlines
    assert below.points[0][0] < below.points[-1][0]  # on the floor, from left to right
    assert below.arrow[1][1] < below.arrow[0][1]  # and its right is towards the camera
    at_rest(controller, qtbot)
    columns = controller.document.session.tracks.columns()
    found = passages(columns, controller.document.recording.fps, [line])
    assert controller.of(CountController).counts.lines[0].totals == found.totals


def test_a_corner_in_the_picture_is_dragged_though_there_are_lines_on_the_floor(
    window, counted, press, qtbot
):
    controller = counted(regions=())
    press(Key.Key_3, Qt.KeyboardModifier.AltModifier)
    layer = controller.labelling._shapes.on_picture
    start = layer.canvas.viewport.point(*SCREEN.end).toPoint()
    QTest.mousePress(layer, LEFT, pos=start)
    QTest.mouseMove(layer, start + QPoint(-40, 0))
    QTest.mouseRelease(layer, LEFT, pos=start + QPoint(-40, 0))
    gate, screen = controller.document.session.labels.lines
    assert gate == GATE
    assert screen.end[0] == pytest.approx(320 - 40 / layer.canvas.viewport.scale, abs=2.0)


def test_the_flow_map_lies_on_the_floor_while_it_is_asked_for(window, controller, qtbot):
    overhead = window.workspace.overhead
    window.run_command("view.flow_map")
    qtbot.waitUntil(lambda: overhead._flow is not None)
    flow = controller.of(CountController).presenter.counted.flow
    assert flow.most > 0
    assert len(overhead._flow.arrows) > 0
    assert len(overhead._flow.legend) == 3
    before = overhead._flow
    go(controller, qtbot, 10)
    assert overhead._flow is before
    window.run_command("view.flow_map")
    assert overhead._flow is None


def test_people_are_counted_while_they_are_tracked(window, controller, qtbot, tiny_run):
    document = controller.document
    document.apply(plan_lines(document.session.labels, [GATE]))
    document.begin_live()
    document.take_live(_steps_of(tiny_run, *tiny_run.frames))
    controller.draw()
    at_rest(controller, qtbot)
    assert controller.of(CountController).presenter.counted.subject.version[0] == "live"
    found = passages(tiny_run.tracks, document.recording.fps, [GATE])
    assert controller.of(CountController).counts.lines[0].totals == found.totals != (0, 0)
    document.end_live()


def test_where_a_tracker_goes_on_the_people_before_count_too(window, controller, qtbot, tiny_run):
    document = controller.document
    document.apply(plan_lines(document.session.labels, [GATE]))
    document.begin_live(40)
    document.take_live(_steps_of(tiny_run, 40, tiny_run.frames[1]))
    controller.draw()
    at_rest(controller, qtbot)
    found = passages(tiny_run.tracks, document.recording.fps, [GATE])
    assert controller.of(CountController).counts.lines[0].totals == found.totals
    document.end_live()


def _steps_of(run, first: int, stop: int) -> list[StepResult]:
    steps = []
    for frame in range(first, stop):
        rows = between(run.tracks["frame"], frame, frame + 1)
        tracks = {name: column[rows] for name, column in run.tracks.items()}
        particles = run.particles.of_frame(frame)
        seen, pairs = empty(DETECTION_COLUMNS), empty(ASSOCIATION_COLUMNS)
        steps.append(StepResult(frame, tracks, seen, particles, pairs))
    return steps


def test_closing_the_recording_leaves_nothing_behind(window, counted, no_threads_left):
    counted()
    window.run_command("view.counting")
    window.run_command("view.flow_map")
    window.files.close_without_asking()
    assert window.controller is None
    assert not window.workspace.of(CountingPanel).isVisible()
    assert window.workspace.overhead._flow is None
    assert window.workspace.overhead._labels.outlines == ()
