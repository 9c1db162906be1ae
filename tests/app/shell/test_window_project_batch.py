"""A batch that is started from a project, watched, stopped, and left going."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtWidgets import QMessageBox

from app.features.project import batch_process
from app.features.project import controller as project_controller
from app.features.project.batch_dialog import BatchDialog
from app.features.project.batch_process import BatchProcess, BatchWish, command_of
from app.features.project.list_model import STATE
from app.features.project.scene import Mood
from tests.batch.walks import make_walk
from tests.project.projects import ReaderHere
from tracking.batch import BatchState, Doing, Listener, StateFile, batch_folder
from tracking.batch.ledger import Row
from tracking.batch.outcome import Cause, failure
from tracking.batch.watch import STOP
from tracking.translation import msg

_WORKS_ON = ["-c", "import time; time.sleep(600)"]


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """What was read of recordings is kept among the files of the test, and read in this process."""
    place = tmp_path_factory.mktemp("cache")
    monkeypatch.setattr(project_controller, "user_cache_path", lambda *_, **__: place)
    monkeypatch.setattr(project_controller, "ReaderProcess", ReaderHere)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Two recordings."""
    for number, name in enumerate("ab"):
        make_walk(tmp_path / "walks" / name, number)
    return tmp_path / "walks"


def _open_project(window, qtbot, folder: Path) -> None:
    window.files.projects.open(folder)
    project = window.files.projects.project
    qtbot.waitUntil(lambda: project.found is not None and not project.found.wanted)


def test_the_command_is_that_of_the_command_line(tmp_path: Path) -> None:
    wish = BatchWish((tmp_path / "a", tmp_path / "-b"), tmp_path / "out", "flow")
    assert command_of(wish) == [
        *("-m", "app", "batch", "-o", str(tmp_path / "out"), "--tracker", "flow", "--"),
        *(str(tmp_path / "a"), str(tmp_path / "-b")),
    ]


def test_a_batch_tracks_the_recordings_and_the_list_shows_their_sessions(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    page, project = window.project_page, window.files.projects.project
    page.track.click()
    dialog = window.findChild(BatchDialog)
    assert [button.objectName() for button in dialog.choice.buttons()] == [
        *("Not tracked yet", "All of the project")
    ]
    assert dialog.place.text() == str(folder / "results")
    dialog.tracker.setCurrentIndex(dialog.tracker.findData("three-part"))
    dialog.accept()
    assert page.batch.isVisible()
    assert not page.track.isEnabled()
    qtbot.waitUntil(lambda: not project.batches.is_own, timeout=600_000)
    qtbot.waitUntil(lambda: len(project.found.rows[0].sessions) == 1 and not project.found.wanted)
    assert [row.path.name for row in project.found.rows] == ["a.h5", "b.h5"]
    assert not page.batch.isVisible()
    assert page.track.isEnabled()
    assert "The batch is done" in window.notice.text
    assert project.results_folder == folder / "results"


def test_a_batch_that_cannot_begin_says_why(window, qtbot, folder):
    _open_project(window, qtbot, folder)
    (folder / "file").write_text("in the way")
    told: list[str] = []
    batches = window.files.projects.project.batches
    batches.ended.connect(told.append)
    batches.start(BatchWish((folder / "a",), folder / "file"))
    qtbot.waitUntil(lambda: bool(told), timeout=600_000)
    assert told[0].startswith("The batch ended early: cannot make folder")


def test_a_batch_of_another_program_is_watched_and_stopped(window, qtbot, folder):
    out = folder / "results"
    with batch_folder(out):
        told = StateFile(out, {"a": folder / "a"}, Listener())
        doing = {"1": Doing("1", "a", "tracking", 3, 12)}
        told.began(BatchState(4, 1, 1, 0, 0, doing, 30.0))
        _open_project(window, qtbot, folder)
        page = window.project_page
        qtbot.waitUntil(page.batch.isVisible)
        assert page.batch._text.text() == "Batch: 2 of 4 recordings, 1 failed"
        qtbot.waitUntil(lambda: page.row_named("a").cells[STATE - 1] == "Tracking 25%")
        page.cancel_asked.emit()
        assert (out / STOP).exists()
        told.close()
    qtbot.waitUntil(lambda: not page.batch.isVisible())


def test_recordings_that_wait_for_a_batch_show_that_and_no_failure_of_before(window, qtbot, folder):
    out = folder / "results"
    failed = failure(Cause.WORKER, msg("the worker died"))
    with batch_folder(out) as ledger:
        for name in "ab":
            ledger.put(Row(name, folder / name, "", "", "", failed))
        ledger.commit()
        _open_project(window, qtbot, folder)
        page = window.project_page
        assert [page.row_named(name).cells[STATE - 1] for name in "ab"] == ["Failed", "Failed"]
        told = StateFile(out, {"a": folder / "a"}, Listener())
        told.began(BatchState(2, left={"a": None}))
        qtbot.waitUntil(lambda: page.row_named("a").cells[STATE - 1] == "Waiting")
        row = page.row_named("a")
        assert (row.mood, row.detail) == (Mood.QUIET, "no session")
        assert page.row_named("b").cells[STATE - 1] == "Failed"
        told.close()
    qtbot.waitUntil(lambda: page.row_named("a").cells[STATE - 1] == "Failed")


def test_a_window_that_closes_asks_what_becomes_of_its_batch(window, qtbot, folder, monkeypatch):
    began: list[BatchProcess] = []

    class Remembered(BatchProcess):
        def __init__(self, wish: BatchWish) -> None:
            super().__init__(wish)
            began.append(self)

    monkeypatch.setattr(batch_process, "command_of", lambda _: _WORKS_ON)
    monkeypatch.setattr("app.features.project.batch_watch.BatchProcess", Remembered)
    _open_project(window, qtbot, folder)
    window.files.projects.project.batches.start(BatchWish((folder / "a",), folder / "results"))
    window.close()
    assert window.isVisible()
    _press(window, "Cancel")
    assert window.isVisible()
    window.close()
    _press(window, "Stop it")
    assert began[0].wait(60)
    assert not window.isVisible()


def _press(window, name: str) -> None:
    boxes = window.findChildren(QMessageBox, "batch")
    box = next(one for one in boxes if one.isVisible())
    buttons = {button.text(): button for button in box.buttons()}
    assert set(buttons) == {"Leave it going", "Stop it", "Cancel"}
    buttons[name].click()


def test_what_a_batch_says_in_the_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    endings = {
        "0": "The batch is done.",
        "3": "The batch is done; some recordings failed: the list says why.",
        "1": "The batch tracked no recording: the list says why.",
        "130": "The batch was stopped. Started again, it goes on from here.",
    }
    for status, words in endings.items():
        monkeypatch.setattr(
            batch_process, "command_of", lambda _, n=status: ["-c", f"import sys; sys.exit({n})"]
        )
        process = BatchProcess(BatchWish((), tmp_path))
        assert process.wait(60)
        assert process.told() == words
        process.close()
