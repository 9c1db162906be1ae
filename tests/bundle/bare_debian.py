"""`python -m tests.bundle.bare_debian PACKAGE [--picture PNG]`: tried in a Debian that has nothing.

Makes a root file system with debootstrap (which must be installed; run as root), puts the package
or the archive into it, and runs the program there: `doctor`, the demo rendered, tracked and saved,
and the window with it on a screen of Xvfb, of which a picture is taken.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests.bundle.archives import LIBRARIES

_SCREEN = ":93"
_WINDOW_S = 60
_PICTURE = """
import sys
from PySide6.QtGui import QGuiApplication
app = QGuiApplication(sys.argv[:1])
picture = app.primaryScreen().grabWindow(0)
assert picture.save(sys.argv[1])
image = picture.toImage()
step = 16
print(len({image.pixel(x, y) for x in range(0, image.width(), step)
           for y in range(0, image.height(), step)}))
"""
_FEWEST_COLOURS = 20
"""A screen without a window has one."""


def main() -> None:
    """Try it, say what was done, and exit with status 1 where something fails."""
    parser = argparse.ArgumentParser(prog="python -m tests.bundle.bare_debian", description=__doc__)
    parser.add_argument("package", type=Path, help=".deb or .tar.gz of `python -m tests.bundle`")
    parser.add_argument("--picture", type=Path, default=None, help="of the window; default: none")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary, bare_root(Path(temporary) / "root") as root:
        if shutil.which("python3", path=str(root / "usr" / "bin")):
            sys.exit("there is a Python in the bare root")
        program = installed(root, asked.package.resolve())
        for words in (("--version",), ("doctor",), ("demo", "--out", "/demo", "--no-gui")):
            print(f"$ trackwright {' '.join(words)}", flush=True)
            in_root(root, program, *words)
        sessions = [str(file.relative_to(root)) for file in (root / "demo").rglob("*.h5")]
        print("saved:", *sessions)
        if not sessions:
            sys.exit("no session was saved")
        colours = shown(root, program, f"/{sessions[0]}", asked.picture)
        print(f"window: {colours} colours on the screen")
        if colours < _FEWEST_COLOURS:
            sys.exit("no window is seen")


@contextmanager
def bare_root(root: Path) -> Iterator[Path]:
    """A Debian with the packages that every Debian has, and its processes' folder."""
    release = dict(
        line.split("=", 1)
        for line in Path("/etc/os-release").read_text().splitlines()
        if "=" in line
    )
    command = ("debootstrap", "--variant=minbase", release["VERSION_CODENAME"], str(root))
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(("mount", "-t", "proc", "proc", str(root / "proc")), check=True)
    try:
        yield root
    finally:
        subprocess.run(("umount", "--lazy", str(root / "proc")), check=True)


def installed(root: Path, package: Path) -> str:
    """Put the package or the archive there; gives the program's path in the root."""
    if package.suffix == ".deb":
        shutil.copy(package, root / "tmp" / package.name)
        in_root(root, "apt-get", "install", "-y", "-q", f"/tmp/{package.name}", quiet=True)
        return "/usr/bin/trackwright"
    in_root(
        root, "apt-get", "install", "-y", "-q", "--no-install-recommends", *LIBRARIES, quiet=True
    )
    shutil.unpack_archive(package, root / "opt", filter="tar")
    return "/opt/trackwright/trackwright"


def in_root(root: Path, *words: str, quiet: bool = False) -> None:
    """Run a command in the root; ends this program where it fails."""
    told = subprocess.DEVNULL if quiet else None
    done = subprocess.run(("chroot", root, *words), env=_environment(), check=False, stdout=told)
    if done.returncode:
        sys.exit(f"{' '.join(words)}: exit status {done.returncode}")


def _environment() -> dict[str, str]:
    path = "/usr/sbin:/usr/bin:/sbin:/bin"
    return {"PATH": path, "HOME": "/root", "LANG": "C.UTF-8", "DEBIAN_FRONTEND": "noninteractive"}


def shown(root: Path, program: str, session: str, picture: Path | None) -> int:
    """Open the session in the window; gives how many colours are seen on the screen then."""
    screen = subprocess.Popen(("Xvfb", _SCREEN, "-screen", "0", "1280x800x24", "-nolisten", "unix"))
    try:
        time.sleep(2)
        words = ("chroot", root, program, "open", session)
        window = subprocess.Popen(words, env={**_environment(), "DISPLAY": _SCREEN})
        try:
            time.sleep(_WINDOW_S)
            if window.poll() is not None:
                sys.exit(f"the window ended by itself: exit status {window.returncode}")
            with tempfile.TemporaryDirectory() as temporary:
                file = picture or Path(temporary) / "window.png"
                looking = (sys.executable, "-c", _PICTURE, str(file))
                there = {**os.environ, "DISPLAY": _SCREEN, "QT_QPA_PLATFORM": "xcb"}
                said = subprocess.run(
                    looking, env=there, check=True, capture_output=True, text=True
                )
            return int(said.stdout)
        finally:
            window.terminate()
            window.wait()
    finally:
        screen.terminate()
        screen.wait()


if __name__ == "__main__":
    main()
