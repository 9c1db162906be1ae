"""Where the installed command starts; installed as the module `trackwright`, outside of `app`.

`app` and `tracking` are names that other programs use, too. A PYTHONPATH that holds another package
of that name comes before the installed ones, so this module says where ours are. It must not
import them before it has said so.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path
from types import ModuleType

OWN = ("app", "tracking", "resources")
"""Packages that are found where this program is installed, and nowhere else."""


class OwnPackages:
    """Finds the packages of this program in the given folders; of all others it knows nothing."""

    def __init__(self, folders: Iterable[str]) -> None:
        """The folders that hold the packages, as in `sys.path`."""
        self._folders = list(folders)

    def find_spec(
        self, name: str, _path: Sequence[str] | None = None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Where a package of ours is; None for any other name (see `sys.meta_path`)."""
        return PathFinder.find_spec(name, self._folders, target) if name in OWN else None


def install_folders(module: Path) -> Iterator[str]:
    """The folders that hold our packages.

    A wheel puts them beside this module. An editable install puts a `.pth` file there instead,
    which names the checkout.

    Args:
        module: the file of this module, as it is installed.
    """
    yield str(module.parent)
    for file in module.parent.glob("_*trackwright.pth"):
        yield from filter(None, file.read_text(encoding="utf-8").splitlines())


def main() -> None:
    """Run what was typed and exit."""
    sys.meta_path.insert(0, OwnPackages(install_folders(Path(__file__).resolve())))
    from app.core.interrupts import ending_at_once

    with ending_at_once():
        from app.__main__ import main as run_and_exit

    run_and_exit()


if __name__ == "__main__":
    main()
