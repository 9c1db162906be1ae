"""Every way a command can end, as a status and a line."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from app.__main__ import run
from app.cli.failure import run_reporting_errors
from tracking.errors import RecordingError


def raises(error: BaseException) -> Callable[[], None]:
    def work() -> None:
        raise error

    return work


@pytest.fixture(autouse=True)
def log_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("platformdirs.user_log_dir", lambda *_, **__: str(tmp_path / "log"))
    return tmp_path / "log"


def test_done_is_silent(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_reporting_errors(lambda: None, debug=False) == 0
    assert capsys.readouterr() == ("", "")


def test_an_expected_error_is_one_line(
    capsys: pytest.CaptureFixture[str], log_folder: Path
) -> None:
    assert run_reporting_errors(raises(RecordingError("left.mp4\nhas no frames")), debug=False) == 1
    assert capsys.readouterr().err == "trackwright: left.mp4 has no frames\n"
    assert not log_folder.exists()


def test_debug_shows_the_traceback(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_reporting_errors(raises(RecordingError("left.mp4 has no frames")), debug=True) == 1
    assert "Traceback" in capsys.readouterr().err


def test_a_bug_is_said_to_be_one_and_logged(
    capsys: pytest.CaptureFixture[str], log_folder: Path
) -> None:
    assert run_reporting_errors(raises(ZeroDivisionError("by nothing")), debug=False) == 1
    err = capsys.readouterr().err
    assert "this is a bug in trackwright: ZeroDivisionError: by nothing" in err
    assert err.count("\n") == 1
    assert "Traceback" in (log_folder / "errors.log").read_text()


def test_a_bug_is_told_where_no_log_can_be_kept(
    capsys: pytest.CaptureFixture[str], log_folder: Path
) -> None:
    log_folder.write_text("a file where the folder should be")
    assert run_reporting_errors(raises(ZeroDivisionError("by nothing")), debug=False) == 1
    assert "--debug" in capsys.readouterr().err


def test_an_interruption_is_status_130(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_reporting_errors(raises(KeyboardInterrupt()), debug=False) == 130
    assert capsys.readouterr().err == "trackwright: interrupted; nothing half-done was kept\n"


def test_missing_memory_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert run_reporting_errors(raises(MemoryError()), debug=False) == 1
    assert "not enough memory" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["nonsense"], ["score"], ["trackers", "--nonsense"], []])
def test_misuse_is_status_2(capsys: pytest.CaptureFixture[str], words: list[str]) -> None:
    assert run(words) == 2


@pytest.mark.parametrize(
    "name", ["demo", "open", "info", "synth", "trackers", "track", "score", "export", "import"]
)
def test_every_command_explains_itself(capsys: pytest.CaptureFixture[str], name: str) -> None:
    assert run([name, "--help"]) == 0
    assert f"trackwright {name}" in capsys.readouterr().out


@pytest.mark.parametrize("words", [["--help"], ["--version"], ["track", "--nonsense"]])
def test_help_version_and_a_wrong_option_need_no_heavy_library(words: list[str]) -> None:
    code = (
        f"import sys; from app.__main__ import run; run({words});"
        "print([m for m in ('numpy', 'cv2', 'PySide6', 'av', 'h5py') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout.rstrip().endswith("[]")


def test_a_closed_pipe_ends_quietly(tmp_path: Path) -> None:
    rows = "".join(f"{n},1,1,1,5,5,1,-1,-1,-1\n" for n in range(1, 50))
    (tmp_path / "truth.txt").write_text(rows)
    command = f"{sys.executable} -m app score truth.txt --truth truth.txt | true"
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env={"PYTHONPATH": str(Path(__file__).parents[3]), "PATH": "/usr/bin:/bin"},
    )
    assert done.stderr == ""


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["score"], "trackwright: Missing argument 'RESULT'; see trackwright score --help"),
        (["review", "x.h5", "--most", "0"], "greater than or equal to 1; see trackwright review"),
        (["track", "x", "--from", "abc"], "'--from'"),
        (["track", "x", "--from", "5"], "--from: it needs a session, --again NAME.h5"),
        (["nonsense"], "No such command 'nonsense'; see trackwright --help"),
    ],
)
def test_what_is_wrongly_asked_for_is_told_in_a_line(
    capsys: pytest.CaptureFixture[str], words: list[str], said: str
) -> None:
    assert run(words) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert said in err


def test_nothing_asked_for_shows_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert run([]) == 2
    assert "Usage: trackwright" in "".join(capsys.readouterr())
