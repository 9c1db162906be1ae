"""A tiny rendered recording, its tracks, and the real window on them."""

from __future__ import annotations

import shutil
import threading
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest
from patient import PATIENCE_S, PatientBot
from PySide6.QtCore import QCoreApplication, QEvent, QSettings
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from run_with_parts import with_parts
from view_fixtures import dark, drawn, heard, inked, near, theme, wheel  # noqa: F401 - fixtures

from app.core import keymap
from app.core.document import document_loader
from app.core.playback import late_camera
from app.core.widgets.user_settings import UserSettings
from app.shell.application import start_application
from app.shell.commands import COMMANDS
from app.shell.main_window import MainWindow
from tracking.people import first_lag, lag_looks
from tracking.pipeline import track
from tracking.recording import Recording, StereoFrame, open_recording
from tracking.session import RecordingReference, Session
from tracking.synthesis import render_recording
from tracking.tracks import Run

TINY_FPS = 8.0
_ONLY_SAID_WITHOUT_A_SCREEN = "This plugin does not support"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The offscreen platform says what it cannot do; that is no warning about the program."""
    here = Path(__file__).parent
    for item in items:
        if here in item.path.parents:
            item.add_marker(pytest.mark.qt_log_ignore(_ONLY_SAID_WITHOUT_A_SCREEN, extend=True))


@pytest.fixture
def qtbot(qapp: QApplication, request: pytest.FixtureRequest) -> QtBot:
    """pytest-qt's own, with more patience."""
    return PatientBot(request)


@pytest.fixture(scope="session")
def tiny_recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Ten seconds of four people on a square, small enough to be made in a few seconds."""
    folder = tmp_path_factory.mktemp("tiny") / "tiny"
    render_recording(folder, "plaza", 10.0, 4, 3, size=(320, 240), fps=TINY_FPS)
    return folder


@pytest.fixture(scope="session")
def tiny_run(tiny_recording: Path) -> Run:
    """What a tracker finds in it; which is the best may change, and people in it with it."""
    with (
        open_recording(tiny_recording) as recording,
        track(recording, "stereo-direction") as tracking,
    ):
        for _ in tracking:
            pass
        return tracking.run()


@pytest.fixture(scope="session")
def lag_known(tiny_recording: Path) -> Iterator[None]:
    """By how much a camera of the tiny recording is late is looked for once, not in each window.

    There it takes a third of the time of a test that opens the window and closes it.
    """
    with open_recording(tiny_recording) as recording:
        told, lag = (recording.sources, recording.right_lag), first_lag(recording)

    def looks(recording: Recording, start: int) -> Generator[int, StereoFrame, int | None]:
        if (recording.sources, recording.right_lag) == told:
            return lag
        return (yield from lag_looks(recording, start))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(late_camera, "lag_looks", looks)
        yield


@pytest.fixture(scope="session")
def made_session(
    tiny_recording: Path, tiny_run: Run, tmp_path_factory: pytest.TempPathFactory
) -> tuple[Path, RecordingReference]:
    """A session of it, made once: each test has a copy."""
    path = tmp_path_factory.mktemp("made") / "tiny.h5"
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [tiny_run], path)
        session.close()
        return path, session.recording


@pytest.fixture
def tiny_session(
    tiny_recording: Path, made_session: tuple[Path, RecordingReference], tmp_path: Path
) -> Path:
    """A saved session of it, fresh for each test, which the user's own program knows."""
    path, reference = made_session
    document_loader.known_recordings().remember(reference, tiny_recording)
    return Path(shutil.copy(path, tmp_path / "tiny.h5"))


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The program's own folder, apart from the one of whoever runs the tests."""
    folder = tmp_path / "own"
    monkeypatch.setattr(document_loader, "user_data_path", lambda *_, **__: folder)
    return folder


@pytest.fixture(autouse=True)
def declared_keys() -> None:
    """Commands have the keys they declare, which texts name, also without a window."""
    keymap.declare(COMMANDS)


@pytest.fixture
def no_threads_left() -> Iterator[None]:
    """Fails where a thread outlives the test; work nobody waits for ends by itself, soon."""
    before = set(threading.enumerate())
    yield
    for thread in threading.enumerate():
        if thread not in before and thread.name.startswith("job "):
            thread.join(PATIENCE_S)
    assert [thread for thread in threading.enumerate() if thread not in before] == []


@pytest.fixture
def remembered(tmp_path: Path) -> UserSettings:
    """Settings kept in a file of the test's own."""
    return UserSettings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))


@pytest.fixture
def window(
    qtbot: QtBot, no_threads_left: None, remembered: UserSettings, lag_known: None
) -> Iterator[MainWindow]:
    """The real window on the welcome page; closed without questions afterwards."""
    start_application(remembered)
    window = MainWindow(remembered)
    window.resize(1280, 800)
    with qtbot.waitExposed(window):
        window.show()
    yield window
    window.files.close_without_asking()
    window.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def parted_session(tiny_recording: Path, tiny_run: Run, tmp_path: Path) -> Path:
    """A saved session of a run that has body parts, fresh for each test."""
    path = tmp_path / "parted.h5"
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [with_parts(tiny_run)], path)
        document_loader.remember_place(session, recording)
        session.close()
    return path


@pytest.fixture(autouse=True)
def own_state(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is remembered of exports is the tests' own."""
    folder = tmp_path_factory.mktemp("state")
    monkeypatch.setattr("app.features.files.own_files.user_state_path", lambda *_, **__: folder)
