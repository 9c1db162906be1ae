"""Are the system libraries there that Qt needs? Run by `make` before the window or its tests.

    python -m app.cli.system_libraries

Silent when all is well. On Debian and Ubuntu what is missing is installed when root asks, otherwise
the one command to run is named; elsewhere the missing library is.
"""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass

PACKAGES = (
    *("libgl1", "libegl1", "libxkbcommon0", "libdbus-1-3", "libfontconfig1", "libglib2.0-0"),
    "fonts-dejavu-core",
    # A real screen's X11 plugin opens these.
    *("libxcb-cursor0", "libxcb-icccm4", "libxcb-image0", "libxcb-keysyms1", "libxcb-randr0"),
    *("libxcb-render-util0", "libxcb-shape0", "libxcb-xinerama0", "libxcb-xkb1"),
    "libxkbcommon-x11-0",
)
"""What Debian and Ubuntu call the libraries; newer releases provide them under the same names."""

INSTALL = ("apt-get", "install", "-y", "--no-install-recommends", *PACKAGES)
_SECONDS = 60

# Runs apart: a missing platform plugin aborts the process that asks for it.
_PROBE = """
import ctypes, os, pathlib, sys
screen = os.environ.get("DISPLAY") and sys.platform == "linux"
os.environ["QT_QPA_PLATFORM"] = "offscreen"
try:
    import PySide6.QtWidgets
    from PySide6.QtGui import QFontDatabase, QGuiApplication
    if screen:
        plugins = pathlib.Path(PySide6.QtWidgets.__file__).parent / "Qt" / "plugins"
        ctypes.CDLL(str(plugins / "platforms" / "libqxcb.so"))
except (ImportError, OSError) as error:
    sys.exit(f"Qt cannot start: {error}")
application = QGuiApplication([])
# These Qt names whatever there is; it crashes once it writes with none behind them.
if not set(QFontDatabase.families()) - {"Monospace", "Sans Serif", "Serif"}:
    sys.exit("Qt finds no font to write with")
"""


@dataclass(frozen=True, slots=True)
class Machine:
    """What is asked of the computer, so that tests can stand in for it.

    Attributes:
        missing: what keeps Qt from starting, in words; empty when nothing does.
        has_apt: a Debian or Ubuntu whose packages can be installed.
        is_root: may install them.
        run: runs a command and gives its exit status.
    """

    missing: Callable[[], str]
    has_apt: bool
    is_root: bool
    run: Callable[[Sequence[str]], int]


def this_machine() -> Machine:
    """The computer this runs on."""
    return Machine(
        missing=_probe,
        has_apt=_is_debian() and shutil.which("apt-get") is not None,
        is_root=hasattr(os, "geteuid") and os.geteuid() == 0,
        run=_run,
    )


def ensure(machine: Machine) -> int:
    """Install or name what is missing; the exit status, 0 when Qt can start."""
    missing = machine.missing()
    if not missing:
        return 0
    command = f"apt-get update && {' '.join(INSTALL)}"
    if not machine.has_apt:
        return _told(f"{missing}; install the system package that holds it, then try again")
    if not machine.is_root:
        return _told(f"{missing}; run: sudo sh -c '{command}'")
    print(f"{missing}; installing the system's packages for it", file=sys.stderr)
    # A stale list of packages may still do, so only the second command decides.
    machine.run(("apt-get", "update", "-q"))
    if machine.run(INSTALL) != 0:
        return _told(f"the packages could not be installed; run: {command}")
    missing = machine.missing()
    return _told(f"{missing}, although its packages are installed") if missing else 0


def _told(reason: str) -> int:
    print(f"trackwright: {reason}", file=sys.stderr)
    return 1


def _probe() -> str:
    """What keeps Qt from starting, tried in a process of its own."""
    try:
        done = subprocess.run(
            [sys.executable, "-c", _PROBE], capture_output=True, text=True, timeout=_SECONDS
        )
    except subprocess.TimeoutExpired:
        return f"Qt did not start within {_SECONDS} s"
    lines = done.stderr.strip().splitlines()
    if done.returncode == 0:
        return ""
    return lines[-1] if lines else f"Qt's process ended with status {done.returncode}"


def _run(command: Sequence[str]) -> int:
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    return subprocess.run(command, env=quiet, stdout=sys.stderr, check=False).returncode


def _is_debian() -> bool:
    """Debian, Ubuntu or one made from them."""
    try:
        release = platform.freedesktop_os_release()
    except OSError:
        return False
    return "debian" in f"{release.get('ID', '')} {release.get('ID_LIKE', '')}".split()


if __name__ == "__main__":
    sys.exit(ensure(this_machine()))
