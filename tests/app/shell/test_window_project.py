"""A project in the window: opened, listed, filtered, its recordings opened and left again."""

from __future__ import annotations

import shutil
from contextlib import closing
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QLabel

from app.features.parts.train_dialog import TrainDialog
from app.features.project import controller as project_controller
from app.features.project.agreement_dialog import AgreementDialog
from tests.batch.walks import FRAMES, make_damaged
from tests.project.projects import ReaderHere, make_project, mark_reviewed
from tracking.editing import plan_label_part
from tracking.session import Session
from tracking.tracks import PartLabel

FRAMES_DONE, STATE, WHO = 2, 8, 9


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three recordings; the first one is tracked; not to be changed."""
    return make_project(tmp_path_factory.mktemp("template") / "walks", ("a", "b", "c"))


@pytest.fixture
def folder(template: Path, tmp_path: Path) -> Path:
    """A copy of it, with a damaged recording."""
    copy = Path(shutil.copytree(template, tmp_path / "walks"))
    make_damaged(copy / "damaged", 1)
    return copy


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """What was read of recordings is kept among the files of the test, and read in this process.

    What a process of its own does is in `tests/project/test_reader_process.py`.
    """
    place = tmp_path_factory.mktemp("cache")
    monkeypatch.setattr(project_controller, "user_cache_path", lambda *_, **__: place)
    monkeypatch.setattr(project_controller, "ReaderProcess", ReaderHere)


def _names(window) -> list[str]:
    shown = window.project_page.table.shown
    return [shown.index(row, 0).data() for row in range(shown.rowCount())]


def _cell(window, name: str, column: int) -> str:
    shown = window.project_page.table.shown
    return shown.index(_names(window).index(name), column).data()


def _is_read(window) -> bool:
    found = window.files.projects.project.found
    return found is not None and bool(found.rows) and not found.wanted


def _open_project(window, qtbot, folder: Path) -> None:
    window.files.projects.open(folder)
    qtbot.waitUntil(lambda: _is_read(window))


def test_a_project_lists_its_recordings_and_what_is_known_of_them(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    assert window.project_page.isVisible()
    assert window.windowTitle() == "walks \u2013 trackwright"
    assert _names(window) == ["a", "b", "c", "damaged"]
    assert _cell(window, "a", 1) == "0:00:02"
    assert _cell(window, "a", FRAMES_DONE) == str(FRAMES)
    assert _cell(window, "a", 3) == "1"
    assert _cell(window, "a", 7) != ""
    assert _cell(window, "b", STATE) == "Not tracked"
    assert _cell(window, "damaged", STATE) == "Cannot be read"
    row = window.project_page.row_named("damaged")
    assert "left.mp4" in row.detail
    image = window.project_page.table.recordings.image(window.project_page.row_named("b"))
    assert image.width() == 240
    assert folder.resolve() in window.remembered.recent


def test_the_list_is_filtered_and_sorted_and_used_by_keys_alone(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    page = window.project_page
    qtbot.keyClick(page, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(page.filter.hasFocus)
    qtbot.keyClicks(page.filter, "not tracked")
    assert _names(window) == ["b", "c"]
    page.filter.setText("nobody")
    assert not page.table.isVisible()
    page.filter.clear()
    page.table.sortByColumn(0, Qt.SortOrder.DescendingOrder)
    assert _names(window) == ["damaged", "c", "b", "a"]
    page.table.choose("b")
    qtbot.keyClick(page.table, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: window.controller is not None)
    assert window.controller.document.recording.name == "b"
    assert window.workspace.isVisible()


def test_a_session_opens_and_closing_it_leads_back_to_the_list(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    page = window.project_page
    page.table.choose("a")
    page.open_asked.emit(page.table.chosen()[0])
    qtbot.waitUntil(lambda: window.controller is not None)
    assert window.controller.document.session.path == folder / "a.h5"
    window.run_command("file.project")
    qtbot.waitUntil(page.isVisible)
    assert window.controller is None
    assert page.table.current_name() == "a"
    window.run_command("file.close_project")
    assert window.welcome.isVisible()


def test_a_session_that_another_program_saves_is_shown_anew(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    mark_reviewed(folder / "a.h5", "Bo", 0, FRAMES)
    window.files.projects.project.look()
    qtbot.waitUntil(lambda: _cell(window, "a", WHO) == "Bo")
    shutil.rmtree(folder / "c")
    window.files.projects.project.look()
    qtbot.waitUntil(lambda: _names(window) == ["a", "b", "damaged"])


def test_next_to_review_opens_the_recording_of_most_worth_or_says_why_not(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    page, project = window.project_page, window.files.projects.project
    assert page.scene.next_row == "a"
    qtbot.mouseClick(page.next, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: window.controller is not None)
    assert window.controller.document.session.path == folder / "a.h5"
    window.bring_up_to_date()
    assert "other recordings" in window.menus.actions["file.next_recording"].statusTip()
    window.run_command("file.project")
    qtbot.waitUntil(page.isVisible)
    mark_reviewed(folder / "a.h5", "Bo", 0, FRAMES)
    project.look()
    qtbot.waitUntil(lambda: _cell(window, "a", STATE) == "All decided" and not page.scene.next_row)
    assert not page.next.isEnabled()
    assert page.scene.next_text == "Nothing is left to review"


def test_a_folder_of_recordings_is_a_project_however_it_is_opened(window, qtbot, folder):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(folder))])
    copy = Qt.DropAction.CopyAction
    button, keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    window.dropEvent(QDropEvent(QPointF(50, 50), copy, data, button, keys))
    qtbot.waitUntil(lambda: _is_read(window))
    assert window.project_page.isVisible()
    window.files.projects.close_project()
    window.run_command("file.open_project")
    dialog = QApplication.activeModalWidget() or window.findChild(QFileDialog)
    assert isinstance(dialog, QFileDialog)
    assert dialog.fileMode() is QFileDialog.FileMode.Directory
    dialog.reject()
    assert not window.menus.actions["file.project"].isEnabled()


def test_an_empty_folder_says_what_to_do(window, qtbot, tmp_path):
    (tmp_path / "empty").mkdir()
    window.files.projects.open(tmp_path / "empty")
    qtbot.waitUntil(lambda: window.files.projects.project.found is not None)
    page = window.project_page
    assert not page.table.isVisible()
    assert page.scene.empty.startswith("No recordings or sessions are in this folder")


def test_a_folder_that_has_gone_is_told(window, qtbot, tmp_path):
    window.files.projects.open(tmp_path / "gone")
    qtbot.waitUntil(lambda: "cannot read the folder" in window.notice.text)


def test_names_of_files_are_plain_text(window, qtbot, folder):
    (folder / "b").rename(folder / "<b>bold<b>")
    _open_project(window, qtbot, folder)
    assert "<b>bold<b>" in _names(window)
    labels = window.project_page.findChildren(QLabel)
    assert {label.textFormat() for label in labels} == {Qt.TextFormat.PlainText}


def test_agreement_between_annotators_is_a_table_with_totals(window, qtbot, folder):
    actions = window.menus.actions
    _open_project(window, qtbot, folder)
    window.bring_up_to_date()
    assert actions["file.agreement"].statusTip() == "no recording of the project has two sessions"
    (folder / "bo").mkdir()
    shutil.copy(folder / "a.h5", folder / "bo" / "a.h5")
    mark_reviewed(folder / "a.h5", "Ada")
    mark_reviewed(folder / "bo" / "a.h5", "Bo")
    window.files.projects.project.look()
    qtbot.waitUntil(lambda: bool(window.files.projects.project.compared) and _is_read(window))
    window.bring_up_to_date()
    window.project_page.actions_of["file.agreement"].click()
    qtbot.waitUntil(lambda: window.findChild(AgreementDialog) is not None)
    dialog = window.findChild(AgreementDialog)
    cells = [dialog.table.item(0, column).text() for column in range(5)]
    assert cells == ["a", "Ada", "Bo", "1.000", "1.000"]
    assert dialog.total.text().startswith("IDF1 1.000  \u00b7  kappa 1.000  \u00b7  1 recording")
    dialog.reject()


def test_a_detector_is_trained_from_all_sessions_with_labels(
    window, qtbot, parted_session, tmp_path
):
    folder = tmp_path / "parted"
    folder.mkdir()
    for name in ("one", "two"):
        copy = Path(shutil.copy(parted_session, folder / f"{name}.h5"))
        with closing(Session.open(copy)) as session:
            run = session.corrected_run
            frame, track = (int(run.parts[column][0]) for column in ("frame", "track"))
            label = PartLabel(frame, track, 0, (1.0, 1.0, 9.0, 9.0))
            session.apply(plan_label_part(session.labels, label))
            session.save()
    _open_project(window, qtbot, folder)
    assert len(window.files.projects.project.labelled) == 2
    window.run_command("file.train_project")
    dialog = window.findChild(TrainDialog)
    qtbot.waitUntil(lambda: dialog._list.count() == 2)
    dialog.reject()


def test_a_folder_opened_as_a_project_comes_back_as_one_from_the_first_page(
    window, qtbot, tmp_path
):
    pictures = tmp_path / "p2" / "pics"
    pictures.mkdir(parents=True)
    for number in range(3):
        (pictures / f"{number}.jpg").write_bytes(b"")
    window.files.projects.open(tmp_path / "p2")
    window.files.projects.close_project()
    window.files.open_recent((tmp_path / "p2").resolve())
    qtbot.waitUntil(lambda: window.files.projects.is_open)
    assert window.files.setup.dialog is None
    assert window.files.welcome_scene().recent[0].detail.startswith("project")
