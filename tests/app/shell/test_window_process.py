"""The window as a process of its own: ended from outside, politely or not."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from patient import PATIENCE_S
from PySide6.QtCore import QSettings

from app.core.widgets.user_settings import Place, UserSettings
from app.shell.application import borrowed_window, show_document
from app.shell.main_window import MainWindow

_PROGRAM = """
import sys
from pathlib import Path
from app.shell.application import run
sys.exit(run(Path(sys.argv[1])))
"""
_ROOT = Path(__file__).parents[3]


def _settings(home: Path) -> UserSettings:
    path = home / "trackwright" / "trackwright.conf"
    return UserSettings(QSettings(str(path), QSettings.Format.IniFormat))


@pytest.fixture
def start(tmp_path, tiny_recording):
    """Start the program on the recording, in a home of its own, and wait until it is open."""
    started = []

    def begin(path: Path = tiny_recording) -> subprocess.Popen[str]:
        names = ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")
        homes = dict.fromkeys(names, str(tmp_path))
        process = subprocess.Popen(
            [sys.executable, "-c", _PROGRAM, str(path)],
            cwd=_ROOT,
            env={**os.environ, **homes, "QT_QPA_PLATFORM": "offscreen"},
            stderr=subprocess.PIPE,
            text=True,
        )
        started.append(process)
        patience_s = time.monotonic() + PATIENCE_S
        while not _settings(tmp_path).left_open and time.monotonic() < patience_s:
            assert process.poll() is None
            time.sleep(0.05)
        return process

    yield begin
    for process in started:
        process.kill()
        process.communicate()


@pytest.mark.skipif(sys.platform != "linux", reason="settings stand elsewhere")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_signal_closes_the_window_quietly(start, tmp_path, name):
    process = start()
    process.send_signal(getattr(signal, name))
    _, said = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 0
    assert [line for line in said.splitlines() if "This plugin does not" not in line] == []
    assert _settings(tmp_path).left_open == ()


@pytest.mark.skipif(sys.platform != "linux", reason="settings stand elsewhere")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_who_ends_it_at_the_terminal_is_told_where_the_unsaved_work_is(
    start, tmp_path, own_folder, tiny_session, tiny_recording, name
):
    unsaved = tmp_path / "trackwright" / "unsaved" / f"{tiny_recording.stem}-1.h5"
    unsaved.parent.mkdir(parents=True)
    tiny_session.rename(unsaved)
    (own_folder / "recordings.json").rename(tmp_path / "trackwright" / "recordings.json")
    process = start(unsaved)
    process.send_signal(getattr(signal, name))
    _, said = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 0
    assert str(unsaved) in said


@pytest.mark.skipif(sys.platform != "linux", reason="settings stand elsewhere")
def test_what_was_open_when_the_process_was_killed_is_known(start, tmp_path, tiny_recording):
    process = start()
    process.kill()
    process.communicate(timeout=PATIENCE_S)
    settings = _settings(tmp_path)
    assert settings.left_open == (tiny_recording.resolve(),)
    assert settings.place(tiny_recording.resolve()) == Place(0)


_INTERRUPTED_WHILE_MADE = """
import os, signal, sys
from PySide6.QtCore import QEvent, QObject
from PySide6.QtWidgets import QMainWindow
from app.shell import application
from app.core.widgets.user_settings import UserSettings

class Interrupt(QObject):
    done = False
    def eventFilter(self, watched, event):
        if isinstance(watched, QMainWindow) and not self.done:
            self.done = True
            os.kill(os.getpid(), signal.SIGINT)
        return False

interrupt = Interrupt()
application.start_application(UserSettings()).installEventFilter(interrupt)
signal.signal(signal.SIGINT, signal.default_int_handler)
sys.exit(application.run(None))
"""
_QUIT_BY_THE_SYSTEM = """
import sys
from PySide6.QtCore import QCoreApplication, QTimer
from app.shell import application
from app.core.widgets.user_settings import UserSettings

application.start_application(UserSettings())
timer = QTimer(interval=200)
timer.timeout.connect(QCoreApplication.quit)
timer.start()
sys.exit(application.run(None))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals there")
@pytest.mark.parametrize("program", [_INTERRUPTED_WHILE_MADE, _QUIT_BY_THE_SYSTEM])
def test_a_window_is_taken_down_in_order_whenever_it_is_to_end(tmp_path, program):
    names = ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")
    homes = dict.fromkeys(names, str(tmp_path))
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=_ROOT,
        env={**os.environ, **homes, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
    )
    lines = [line for line in done.stderr.splitlines() if "This plugin does not" not in line]
    assert (done.returncode, lines) == (0, [])


def _draw(use: Callable[[MainWindow], None]) -> None:
    with borrowed_window("dark", (800, 600)) as window:
        use(window)


def test_a_signal_while_a_window_is_only_drawn_interrupts_the_command(tiny_recording):
    before = signal.getsignal(signal.SIGINT)

    def interrupt(window: MainWindow) -> None:
        window.work.changed.connect(lambda: os.kill(os.getpid(), signal.SIGINT))
        show_document(window, tiny_recording)

    with pytest.raises(KeyboardInterrupt):
        _draw(interrupt)
    assert signal.getsignal(signal.SIGINT) is before
