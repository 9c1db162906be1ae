"""Every text of the window, its panels and its dialogs is read, in both looks."""

from __future__ import annotations

import pytest
from opened_session import PANELS, laid_out, open_with_anna, told
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QDialog, QLabel, QWidget
from readable import read

from app.core.look.theme import Look, apply_look, load_theme
from app.features.setup.scene import Step

_DIALOGS = (
    *("tracks.track", "file.export", "file.author", "detector.train", "help.keys", "tracks.runs"),
    *("help.doctor", "edit.keys", "view.jobs", "file.export_clip"),
)


@pytest.fixture(params=[Look.DARK, Look.LIGHT], ids=lambda look: look.value)
def look(request, qapp):
    """The look the window has."""
    yield request.param
    apply_look(qapp, Look.DARK)


@pytest.fixture
def opened(window, look, qtbot, parted_session):
    window.resize(1280, 800)
    window.look_choice.choose(look)
    open_with_anna(window, qtbot, parted_session)
    return window


def test_the_window_and_its_panels(opened, qtbot):
    readings = read(opened)
    found, known = list(readings.faults), set(readings.least)
    for name in PANELS:
        opened.run_command(name)
        laid_out(qtbot)
        readings = read(opened)
        found += [f"{name}: {one}" for one in readings.faults]
        known |= set(readings.least)
        opened.run_command(name)
    assert len(known) > 60
    assert told(found) == ""


def test_the_dialogs(opened, qtbot):
    found = []
    for command in _DIALOGS:
        opened.run_command(command)
        qtbot.waitUntil(lambda: any(one.isVisible() for one in opened.findChildren(QDialog)))
        laid_out(qtbot)
        for dialog in [one for one in opened.findChildren(QDialog) if one.isVisible()]:
            readings = read(dialog)
            assert readings.least, command
            found += [f"{command}: {one}" for one in readings.faults]
            dialog.close()
    assert told(found) == ""


def test_the_first_page_and_the_search_of_commands(window, look, qtbot):
    window.look_choice.choose(look)
    laid_out(qtbot)
    found = read(window).faults
    window.run_command("edit.commands")
    laid_out(qtbot)
    found += read(window.palette_of_commands).faults
    window.palette_of_commands.close()
    assert told(found) == ""


def test_the_steps_of_the_set_up(begin, with_calibration, qapp, look, qtbot):
    dialog, found = begin(with_calibration).dialog, []
    apply_look(qapp, look)
    for step in Step:
        dialog.go_to(step)
        laid_out(qtbot)
        found += [f"{step}: {one}" for one in read(dialog).faults]
    assert told(found) == ""


# faults that are told


class _Painted(QWidget):
    """Writes a word in an ink."""

    ink = QColor()

    def paintEvent(self, _: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        painter = QPainter(self)
        painter.fillRect(self.rect(), load_theme("dark").window)
        painter.setPen(self.ink)
        painter.drawText(self.rect(), 0, "painted")


@pytest.mark.parametrize(("code", "told_of"), [("#e6e9ed", 0), ("#5a6068", 2)])
def test_a_faint_text_is_told(qapp, qtbot, code, told_of):
    apply_look(qapp, Look.DARK)
    page, painted = QWidget(), _Painted()
    qtbot.addWidget(page)
    label = QLabel("written", page)
    label.setStyleSheet(f"color: {code}")
    painted.setParent(page)
    painted.ink = QColor(code)
    label.setGeometry(0, 0, 120, 30)
    painted.setGeometry(0, 40, 120, 30)
    page.resize(160, 100)
    with qtbot.waitExposed(page):
        page.show()
    readings = read(page)
    assert len(readings.least) == 2
    assert len(readings.faults) == told_of
