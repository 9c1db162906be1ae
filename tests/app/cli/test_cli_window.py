"""Where no window can be opened, the command says why in one line."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from app.cli.display import why_no_window


def test_a_window_without_a_screen_that_answers_ends_in_one_clear_line() -> None:
    environment = {**os.environ, "DISPLAY": ":4711"}
    for name in ("QT_QPA_PLATFORM", "WAYLAND_DISPLAY"):
        environment.pop(name, None)
    done = subprocess.run(
        [sys.executable, "-m", "app", "open"], env=environment, capture_output=True, text=True
    )
    assert (done.returncode, done.stdout) == (1, "")
    (line,) = done.stderr.splitlines()
    assert line.startswith("trackwright: ")
    assert "display :4711" in line or "system library" in line


def test_a_library_that_is_missing_is_named_with_what_installs_it() -> None:
    def load(path: str) -> None:
        assert path.endswith("libqxcb.so")
        raise OSError("libxcb-cursor.so.0: cannot open shared object file\nand more")

    why = why_no_window({"DISPLAY": ":0"}, "linux", load)
    assert "libxcb-cursor.so.0: cannot open shared object file;" in why
    assert "apt-get install" in why
    assert "libxcb-cursor0" in why
    assert "\n" not in why


@pytest.mark.parametrize(("system", "missing"), [("darwin", False), ("linux", True)])
def test_only_linux_needs_a_display_to_be_named(system: str, missing: bool) -> None:
    assert bool(why_no_window({}, system)) is missing
