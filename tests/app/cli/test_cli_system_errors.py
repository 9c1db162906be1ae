"""What the system refuses of a file is one line about that file, through every command."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import Trackwright

from app.cli.failure import run_reporting_errors

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="permissions of POSIX")
ROW = "1,1,1,1,5,5,1,-1,-1,-1\n"
CHECKOUT = Path(__file__).parents[3]


def commands(bad: Path, session: Path, footage: Path, out: Path) -> list[tuple[str | Path, ...]]:
    """Commands that read `bad`, and commands that write it."""
    text = out / "good.txt"
    text.write_text(ROW)
    return [
        ("info", bad),
        ("log", bad),
        ("review", bad),
        ("restore", bad),
        ("restore", bad, "--list"),
        ("count", bad, "--line", "door:0,0:1,1"),
        ("compare", session, bad),
        ("score", bad, "--truth", text),
        ("score", text, "--truth", bad),
        ("train", bad, "-o", out / "d.h5"),
        ("track", "--again", bad, "--from", "3"),
        ("import", bad, "-r", footage, "-o", out / "new.h5"),
        ("import", text, "-r", bad, "-o", out / "new.h5"),
        ("import", text, "--into", bad),
        ("import-labels", text, bad),
        ("export", bad, "-o", out / "o.txt", "--format", "mot"),
        ("export", session, "-o", bad, "--format", "mot", "--force"),
        ("export", session, "-o", bad, "--format", "pedpy-h5", "--force"),
        ("export", session, "-o", bad / "folder", "--format", "x-anylabeling", "--force"),
        ("log", session, "--csv", bad),
        ("count", session, "--line", "door:0,0:1,1", "--csv", bad),
        ("score", text, "--truth", text, "--report", bad),
        ("track", footage, "-o", bad, "--frames", "0:2"),
        ("import", text, "-r", footage, "-o", bad),
    ]


@pytest.mark.parametrize(
    "bad",
    [
        lambda folder: folder / f"{'x' * 300}.h5",
        lambda folder: folder / ("y" * 300) / "a.h5",
        lambda folder: file_at(folder / "file.txt") / "a.h5",
        lambda folder: folder / "missing" / "a.h5",
        lambda folder: loop_at(folder / "loop.h5"),
    ],
    ids=["long name", "long folder", "through a file", "missing folder", "loop of links"],
)
def test_a_path_that_cannot_be_is_told_in_a_line(
    trackwright: Trackwright,
    session: Path,
    footage: Path,
    tmp_path: Path,
    bad: Callable[[Path], Path],
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    place = bad(tmp_path)
    for words in commands(place, session, footage, out):
        if place.name == "a.h5" and "--report" in words and place.parent.name == "missing":
            continue  # a report's folder is made
        if "x-anylabeling" in words and place.parent.name == "missing":
            continue  # so is that of a format of folders
        status, _, err = trackwright(*words)
        assert_one_line(status, err, words)


def file_at(path: Path) -> Path:
    path.write_text(ROW)
    return path


def loop_at(path: Path) -> Path:
    path.symlink_to(path.name)
    return path


def assert_one_line(status: int, err: str, words: object) -> None:
    last = err.splitlines()[-1]
    assert status in (1, 2), (words, err)
    assert "bug" not in err, (words, err)
    assert last.startswith("trackwright: "), (words, err)


@pytest.fixture
def as_nobody_special() -> list[str]:
    """What to begin a command with so that permissions count, as they do not for root."""
    if os.geteuid() != 0:
        return []
    if shutil.which("setpriv") is None:
        pytest.skip("root may do all")
    return ["setpriv", "--bounding-set=-dac_override,-dac_read_search"]


def test_a_folder_that_may_not_be_entered_is_told_in_a_line(
    as_nobody_special: list[str], session: Path, footage: Path, tmp_path: Path
) -> None:
    closed, out = tmp_path / "closed", tmp_path / "out"
    closed.mkdir()
    out.mkdir()
    bad = Path(shutil.copy(session, closed / "a.h5"))
    every = [list(map(str, words)) for words in commands(bad, session, footage, out)]
    code = (
        "import sys, json; from app.__main__ import run\n"
        "for words in json.loads(sys.argv[1]):\n"
        "    print(f'= {run(words)} {words}', file=sys.stderr, flush=True)\n"
    )
    closed.chmod(0)
    try:
        done = run_code(as_nobody_special, code, every, tmp_path)
    finally:
        closed.chmod(0o700)
    told_of = done.split("= ")
    assert len(told_of) == len(every) + 1, done
    said = ""
    for part, words in zip(told_of[1:], every, strict=True):
        before, said = said or told_of[0], part.partition("\n")[2]
        assert_one_line(int(part.split()[0]), before, words)
        assert "Permission denied" in before, (words, before)


def run_code(before: list[str], code: str, every: list[list[str]], home: Path) -> str:
    import json

    done = subprocess.run(
        [*before, sys.executable, "-c", code, json.dumps(every)],
        cwd=CHECKOUT,
        env={**os.environ, "XDG_STATE_HOME": str(home), "XDG_DATA_HOME": str(home)},
        capture_output=True,
        text=True,
        timeout=200,
    )
    assert done.returncode == 0, done.stderr
    return done.stderr


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (
            PermissionError(13, "Permission denied", "/data/.a.part"),
            "cannot use /data/.a.part: Permission denied; choose another place, or have its "
            "owner let you",
        ),
        (
            OSError(18, "Invalid cross-device link", "a", None, "b"),
            "cannot use a and b: Invalid cross-device link; check the path and its disk",
        ),
        (
            OSError(28, "No space left on device"),
            "cannot go on: No space left on device; make room",
        ),
        (
            PermissionError(13, "Permission denied"),
            "cannot go on: Permission denied; choose another place, or have its owner let you",
        ),
        (
            PermissionError(1, "Operation not permitted"),
            "cannot go on: Operation not permitted; choose another place, or have its ",
        ),
        (
            OSError(5, "Input/output error", b"disk\xff"),
            "cannot use disk\\udcff: Input/output error",
        ),
    ],
)
def test_what_nothing_foresaw_names_the_file(
    capsys: pytest.CaptureFixture[str], error: OSError, said: str
) -> None:
    def work() -> None:
        raise error

    assert run_reporting_errors(work, debug=False) == 1
    err = capsys.readouterr().err
    assert err.startswith(f"trackwright: {said}")
    assert err.count("\n") == 1


def test_what_is_of_no_file_is_still_a_bug(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("platformdirs.user_log_dir", lambda *_, **__: str(tmp_path / "log"))

    def work() -> None:
        raise OSError(9, "Bad file descriptor")

    assert run_reporting_errors(work, debug=False) == 1
    assert "this is a bug" in capsys.readouterr().err
