"""`python -m tests.bundle [--out DIR]`: wheel, folder, archive, Debian package, and their sizes."""

from __future__ import annotations

import argparse
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

from tests.bundle.archives import debian_package, packed_folder
from tests.bundle.environment import ROOT, fresh_environment, run_at
from tests.bundle.trimming import strip_libraries

_PYINSTALLER = "pyinstaller==6.22.3"
_MOST_MB = 250
_EXTRAS = "bags"
"""What is in the folder, too: small, and nobody can add it there."""


def main() -> None:
    """Build everything, print where it is and how large."""
    parser = argparse.ArgumentParser(prog="python -m tests.bundle", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "dist", help="default: dist")
    out = parser.parse_args().out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = build_folder(Path(temporary))
        made = (packed_folder(folder, out), debian_package(folder, out, version("trackwright")))
    for file in made:
        size_mb = file.stat().st_size / 1e6
        print(f"{file}: {size_mb:.0f} MB")
        if size_mb > _MOST_MB:
            sys.exit(f"{file.name} is larger than {_MOST_MB} MB")


def build_folder(work: Path) -> Path:
    """The folder with the program, its Python and its libraries, made in `work`.

    It is made of the wheel in an environment of its own, with the versions of the lock file:
    PyInstaller takes along whatever it finds beside it.
    """
    python = fresh_environment(work, (_EXTRAS,), (_PYINSTALLER,))
    spec = Path(__file__).with_name("trackwright.spec")
    words = ("--noconfirm", "--log-level", "WARN", "--distpath", "folder", "--workpath", "work")
    run_at(work, python, "-m", "PyInstaller", *words, spec)
    folder = work / "folder" / "trackwright"
    strip_libraries(folder)
    return folder


if __name__ == "__main__":
    main()
