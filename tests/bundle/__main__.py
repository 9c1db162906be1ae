"""`python -m tests.bundle [--out DIR]`: wheel, folder, archive, Debian package, and their sizes."""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
import venv
from importlib.metadata import version
from pathlib import Path

from tests.bundle.archives import debian_package, packed_folder

ROOT = Path(__file__).parents[2]
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
    _run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(work), at=ROOT)
    wheel = next(work.glob("*.whl"))
    venv.create(work / "env", with_pip=True)
    python = work / "env" / "bin" / "python"
    locked = work / "constraints.txt"
    locked.write_text(versions_of((ROOT / "requirements.lock").read_text()))
    wanted = (f"{wheel}[{_EXTRAS}]", _PYINSTALLER)
    _run(python, "-m", "pip", "install", "--quiet", "-c", str(locked), *wanted, at=work)
    spec = Path(__file__).with_name("trackwright.spec")
    words = ("--noconfirm", "--log-level", "WARN", "--distpath", "folder", "--workpath", "work")
    _run(python, "-m", "PyInstaller", *words, str(spec), at=work)
    return work / "folder" / "trackwright"


def versions_of(lock: str) -> str:
    """The lock file without its hashes: constraints for what is wanted alone."""
    return "\n".join(
        re.findall(r"^[\w.\[\]-]+==[^\s\\]+(?: ; [^\\\n]*[^\\\s])?", lock, re.MULTILINE)
    )


def _run(*words: str | Path, at: Path) -> None:
    # Where this program was begun from must not hide what the environment holds.
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    subprocess.run([str(word) for word in words], cwd=at, env=clean, check=True)


if __name__ == "__main__":
    main()
