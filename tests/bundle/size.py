"""`python -m tests.bundle.size [--folder DIR] [--extra NAME]`: what takes the room.

Without a folder: an environment is made, the wheel is installed into it with what it needs, and
its packages are measured as they lie on the disk, compiled Python files counted. With the folder of
`python -m tests.bundle`: the parts of that.
"""

from __future__ import annotations

import argparse
import tempfile
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import distributions
from pathlib import Path

from tests.bundle.environment import fresh_environment

_LIBRARIES = (".so", ".dll", ".dylib", ".pyd")
_SMALLEST_MB = 1.0
_INTERNAL = "_internal"


@dataclass(slots=True)
class Part:
    """What a package takes, in bytes: in all, of it libraries, compiled Python, and tests."""

    name: str
    whole: int = 0
    libraries: int = 0
    compiled: int = 0
    tests: int = 0

    def add(self, path: Path, size: int) -> None:
        """Count a file; path: within the package."""
        self.whole += size
        if any(ending in _LIBRARIES for ending in path.suffixes):
            self.libraries += size
        if path.suffix == ".pyc":
            self.compiled += size
        if {"tests", "test"} & set(path.parts):
            self.tests += size


def main() -> None:
    """Measure, and print a table."""
    parser = argparse.ArgumentParser(prog="python -m tests.bundle.size", description=__doc__)
    parser.add_argument("--folder", type=Path, default=None, help="of `python -m tests.bundle`")
    parser.add_argument("--extra", action="append", default=[], help="an extra to be installed")
    asked = parser.parse_args()
    if asked.folder is not None:
        print_table(parts_of_folder(asked.folder))
        return
    with tempfile.TemporaryDirectory() as temporary:
        python = fresh_environment(Path(temporary), asked.extra)
        packages = next(python.parents[1].glob("lib/python*/site-packages"))
        print_table(parts_of_environment(packages))


def parts_of_environment(packages: Path) -> list[Part]:
    """The packages that are installed in a folder, without what a new environment has itself."""
    found = []
    for held in distributions(path=[str(packages)]):
        part = Part(held.metadata["Name"])
        for file in held.files or ():
            place = Path(str(held.locate_file(file)))
            if place.is_file():
                part.add(Path(file), place.lstat().st_size)
        if part.name not in ("pip", "setuptools"):
            found.append(part)
    return found


def parts_of_folder(folder: Path) -> list[Part]:
    """The parts of a folder with the program, by what stands right in it; links count nothing."""
    inner = folder / _INTERNAL
    found: dict[str, Part] = {}
    for path in inner.rglob("*"):
        if path.is_symlink() or not path.is_file():
            continue
        within = path.relative_to(inner)
        name = within.parts[0] if len(within.parts) > 1 else "files right in it"
        found.setdefault(name, Part(name)).add(within, path.stat().st_size)
    return list(found.values())


def print_table(parts: Iterable[Part]) -> None:
    """The largest first; small ones in a line of their own."""
    print(f"{'MB':>7} {'libraries':>10} {'compiled':>9} {'tests':>7}")
    rest, whole = Counter[str](), Counter[str]()
    for part in sorted(parts, key=lambda one: -one.whole):
        sizes = {
            "whole": part.whole,
            "libraries": part.libraries,
            "compiled": part.compiled,
            "tests": part.tests,
        }
        whole.update(sizes)
        if part.whole < _SMALLEST_MB * 1e6:
            rest.update(sizes)
        else:
            print(_line(sizes, part.name))
    print(_line(rest, "smaller ones"))
    print(_line(whole, "all"))


def _line(sizes: dict[str, int] | Counter[str], name: str) -> str:
    in_mb = {each: size / 1e6 for each, size in sizes.items()}
    return (
        f"{in_mb.get('whole', 0):7.1f} {in_mb.get('libraries', 0):10.1f}"
        f" {in_mb.get('compiled', 0):9.1f} {in_mb.get('tests', 0):7.1f}  {name}"
    )


if __name__ == "__main__":
    main()
