"""Every control of every panel and dialog is told to screen readers, and reached by Tab."""

from __future__ import annotations

import pytest
from accessible import faults_of, menu_faults, tab_faults
from opened_session import PANELS, laid_out, open_with_anna, told
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QLineEdit,
    QListWidget,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.features.project import controller as project_controller
from app.features.setup.scene import Step
from tests.project.projects import ReaderHere, make_project

_LISTS = ("labels.occluders", "labels.lines", "labels.regions", "labels.reviewed")
_DIALOGS = (
    *("tracks.track", "file.export", "file.author", "detector.train", "help.keys", "tracks.runs"),
    *("help.doctor", "edit.keys", "view.jobs", "file.export_clip", "review.alike"),
    "tracks.schema",
)


@pytest.fixture
def opened(window, qtbot, parted_session):
    window.resize(1280, 800)
    open_with_anna(window, qtbot, parted_session)
    return window


def test_the_window_and_its_panels(opened, qtbot):
    found = faults_of(opened)
    for name in (*PANELS, *_LISTS):
        opened.run_command(name)
        laid_out(qtbot)
        found += [f"{name}: {one}" for one in faults_of(opened)]
        opened.run_command(name)
    opened.run_command("tracks.swap")
    laid_out(qtbot)
    found += faults_of(opened)
    assert told(found) == ""


def test_the_first_page(window, qtbot):
    laid_out(qtbot)
    assert told((*faults_of(window), *tab_faults(window))) == ""


@pytest.mark.parametrize("command", _DIALOGS)
def test_a_dialog(opened, qtbot, command):
    if command == "review.alike":
        opened.run_command("review.next")
    opened.run_command(command)
    qtbot.waitUntil(lambda: any(one.isVisible() for one in opened.findChildren(QDialog)))
    laid_out(qtbot)
    dialogs = [one for one in opened.findChildren(QDialog) if one.isVisible()]
    if command == "tracks.schema":
        dialogs[0].add.click()  # whose fields are used
    found = [one for dialog in dialogs for one in (*faults_of(dialog), *tab_faults(dialog))]
    for dialog in dialogs:
        dialog.close()
    assert told(found) == ""


def test_the_search_of_commands(opened, qtbot):
    opened.run_command("edit.commands")
    laid_out(qtbot)
    palette = opened.palette_of_commands
    assert told((*faults_of(palette), *tab_faults(palette))) == ""
    palette.close()


def test_the_steps_of_the_set_up(begin, with_calibration, qtbot):
    dialog = begin(with_calibration).dialog
    found = []
    for step in Step:
        dialog.go_to(step)
        laid_out(qtbot)
        found += [f"{step}: {one}" for one in (*faults_of(dialog), *tab_faults(dialog))]
    assert told(found) == ""


def test_the_page_of_a_project(window, qtbot, tmp_path, monkeypatch):
    monkeypatch.setattr(project_controller, "user_cache_path", lambda *_, **__: tmp_path / "cache")
    monkeypatch.setattr(project_controller, "ReaderProcess", ReaderHere)
    folder = make_project(tmp_path / "walks", ("a", "b"))
    projects = window.files.projects
    projects.open(folder)
    qtbot.waitUntil(lambda: projects.project.found is not None)
    qtbot.waitUntil(lambda: bool(projects.project.found.rows) and not projects.project.found.wanted)
    laid_out(qtbot)
    found = [*faults_of(window), *tab_faults(window)]
    window.run_command("file.track_project")
    laid_out(qtbot)
    dialogs = [one for one in window.findChildren(QDialog) if one.isVisible()]
    found += [one for dialog in dialogs for one in (*faults_of(dialog), *tab_faults(dialog))]
    for dialog in dialogs:
        dialog.close()
    assert dialogs
    assert told(found) == ""


def test_every_entry_of_the_menus(opened):
    menus = opened.menus.menus.values()
    assert told(one for menu in menus for one in menu_faults(menu)) == ""


# faults that are told


@pytest.fixture
def page(qtbot):
    """A page of two named fields, which has no fault."""
    page = QWidget()
    qtbot.addWidget(page)
    rows = QVBoxLayout(page)
    for name in ("First", "Second"):
        field = QLineEdit(page)
        field.setAccessibleName(name)
        rows.addWidget(field)
    with qtbot.waitExposed(page):
        page.show()
    assert told((*faults_of(page), *tab_faults(page))) == ""
    return page


def add(page: QWidget, widget: QWidget) -> None:
    page.layout().addWidget(widget)
    widget.show()
    QCoreApplication.sendPostedEvents()


def test_a_control_without_a_name_is_told(page):
    add(page, QCheckBox(page))
    assert "no name" in told(faults_of(page))


def test_a_button_that_is_called_by_a_sign_alone_is_told(page):
    add(page, QPushButton("\N{MULTIPLICATION SIGN}", page))
    assert "no name" in told(faults_of(page))


def test_rows_that_are_only_drawn_are_told(page):
    rows = QListWidget(page)
    rows.setAccessibleName("Rows")
    rows.addItem("")
    add(page, rows)
    assert "nothing is told of row 0" in told(faults_of(page))


def test_an_order_against_reading_is_told(page):
    first, second = page.findChildren(QLineEdit)
    third = QPushButton("Third", page)
    add(page, third)
    QWidget.setTabOrder(first, third)
    QWidget.setTabOrder(third, second)
    assert "which is read later" in told(tab_faults(page))


def test_a_control_that_takes_tab_for_itself_is_told(page):
    class Trap(QToolButton):
        def focusNextPrevChild(self, _: bool) -> bool:  # noqa: N802 - Qt's name
            return True

    trap = Trap(page)
    trap.setText("Trap")
    trap.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    add(page, trap)
    add(page, QPushButton("Behind it", page))
    assert "trapped" in told(tab_faults(page))
    assert "not reached: QPushButton 'Behind it'" in told(tab_faults(page))
