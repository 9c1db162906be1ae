"""Names from people and files are shown as they stand: no markup, nothing loaded, no keys."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QModelIndex, QPoint, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QLabel,
    QMessageBox,
    QTableView,
    QToolTip,
    QTreeView,
    QWidget,
)
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.core.document import document_loader
from app.shell.features import FEATURES
from app.shell.main_window import MainWindow
from tracking.editing import (
    plan_lines,
    plan_regions,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
)
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import CountingLine, Region, Run

MARKED = "<b>x</b><img src='secret.png'>&y[*]"
_ONE_AMPERSAND = re.compile(r"(?<!&)(&&)*&(?!&)")
_ROOT = QModelIndex()
_DIALOGS = (
    *("tracks.track", "tracks.attributes", "file.export", "file.older", "file.author"),
    *("detector.train", "help.keys", "edit.commands", "tracks.runs", "file.import"),
)
_PANELS = tuple(f"view.{feature.id}" for feature in FEATURES if feature.opens)


@pytest.fixture
def hostile_session(tiny_recording: Path, tiny_run: Run, tmp_path: Path) -> Path:
    """A session whose every name is markup."""
    folder = tmp_path / "<b>folder<"
    shutil.copytree(tiny_recording, folder)
    manifest = folder / "recording.toml"
    text = manifest.read_text("utf-8")
    manifest.write_text(re.sub(r"(?m)^name = .*$", f'name = "{MARKED}"', text), "utf-8")
    path = tmp_path / "<i>&s[*].h5"
    with open_recording(folder) as recording:
        runs = [tiny_run, replace(tiny_run, notes=(MARKED,))]
        session = Session.create(recording, runs, path, author=MARKED)
        document_loader.remember_place(session, recording)
    _describe(session)
    session.save()
    session.close()
    return path


def _describe(session: Session) -> None:
    for track in session.tracks.track_ids:
        session.apply(plan_rename(session.tracks, session.labels, track, f"{MARKED}{track}"))
        for plan in (plan_set_attribute, plan_set_notes):
            said = ("colour", MARKED) if plan is plan_set_attribute else (MARKED,)
            session.apply(plan(session.tracks, session.labels, track, *said))
    session.apply(plan_lines(session.labels, [CountingLine(MARKED, (0.0, 1.0), (2.0, 3.0))]))
    corners = ((0.0, 1.0), (2.0, 1.0), (2.0, 3.0))
    session.apply(plan_regions(session.labels, [Region(MARKED, corners)]))


@pytest.fixture
def opened(window: MainWindow, qtbot: QtBot, hostile_session: Path) -> MainWindow:
    window.files.open_path(hostile_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    controller = window.controller
    assert controller is not None
    controller.editing.pick(controller.document.tracks.ids[0])
    qtbot.wait(1)
    return window


def _shown() -> Iterator[QWidget]:
    for top in QApplication.topLevelWidgets():
        yield top
        yield from top.findChildren(QWidget)


def _rendered(label: QLabel) -> bool:
    """Whether its text is laid out as markup, which is where images are loaded."""
    return label.textFormat() != Qt.TextFormat.PlainText and "<" in label.text()


def _faults() -> list[str]:
    faults = []
    for widget in list(_shown()):
        if not isValid(widget):  # a tooltip that is gone
            continue
        if isinstance(widget, QLabel) and _rendered(widget):
            faults.append(f"{type(widget).__name__} {widget.objectName()}: {widget.text()}")
        texts = [action.text() for action in widget.actions() if isinstance(action, QAction)]
        texts += [widget.text()] if isinstance(widget, QAbstractButton) else []
        faults += [text for text in texts if "<b>" in text and _ONE_AMPERSAND.search(text)]
        faults += [f"tooltip: {tip}" for tip in _tips_of(widget) if _tip_is_rendered(tip, widget)]
    return faults


def _tips_of(widget: QWidget) -> set[str]:
    tips = {widget.toolTip()}
    model = widget.model() if isinstance(widget, QAbstractItemView) else None
    for row in range(model.rowCount(_ROOT) if model is not None else 0):
        columns = model.columnCount(_ROOT) if isinstance(widget, QTableView | QTreeView) else 1
        for column in range(columns):
            tip = model.index(row, column).data(Qt.ItemDataRole.ToolTipRole)
            tips.add(str(tip or ""))
    return {tip for tip in tips if "<" in tip}


def _tip_is_rendered(tip: str, widget: QWidget) -> bool:
    QToolTip.showText(QPoint(5, 5), tip, widget)
    labels = [one for one in QApplication.topLevelWidgets() if isinstance(one, QLabel)]
    told = [one for one in labels if one.text() == tip]
    assert told, "no tooltip is shown"
    rendered = any(_rendered(one) for one in told)
    QToolTip.hideText()
    return rendered


def test_no_panel_renders_the_markup_of_names(opened: MainWindow, qtbot: QtBot) -> None:
    shown = [w.text() for w in _shown() if isinstance(w, QLabel | QAbstractButton)]
    assert any("<b>x" in text for text in shown), "no name is shown at all"
    assert _faults() == []
    for command in _PANELS:
        opened.run_command(command)
        qtbot.wait(1)
        assert _faults() == [], command


@pytest.mark.parametrize("command", ["tracks.swap", "tracks.merge", "tracks.split"])
def test_no_edit_that_waits_renders_the_markup_of_names(
    opened: MainWindow, qtbot: QtBot, command: str
) -> None:
    opened.run_command(command)
    qtbot.wait(1)
    assert _faults() == []


def test_no_dialog_renders_the_markup_of_names(opened: MainWindow, qtbot: QtBot) -> None:
    known = {item.command for item in opened.registry.items()}
    done = [command for command in _DIALOGS if command in known]
    assert len(done) >= 5
    for command in done:
        before = set(QApplication.topLevelWidgets())
        opened.run_command(command)
        qtbot.wait(1)
        assert _faults() == [], command
        for dialog in set(QApplication.topLevelWidgets()) - before:
            dialog.close()


def test_no_notice_or_tooltip_renders_markup(opened: MainWindow) -> None:
    opened.notice.say(MARKED)
    opened.say(MARKED)
    assert not _tip_is_rendered(MARKED, opened)
    assert _faults() == []


def test_the_question_about_unsaved_changes_is_plain_text(opened: MainWindow, qtbot: QtBot) -> None:
    controller = opened.controller
    assert controller is not None
    controller.editing.rename(controller.document.selection.track, "<u>other")
    opened.close()
    boxes = opened.findChildren(QMessageBox)
    assert [box.textFormat() for box in boxes] == [Qt.TextFormat.PlainText]
    assert _faults() == []
    boxes[0].reject()


def test_a_name_with_the_sign_of_changes_stands_in_the_title_as_it_is(opened: MainWindow) -> None:
    opened.bring_up_to_date()
    assert "[*][*]" in opened.files.title()
    handle = opened.windowHandle()
    assert handle is not None
    assert "&y[*]" in handle.title()
