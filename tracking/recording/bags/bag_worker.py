"""Starts the program that reads a bag: `python -P bag_worker.py`; see `bag_program`."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType


def _bare_packages(*names: str) -> None:
    """Have packages found without what they import, which takes longer than all work here."""
    root = Path(__file__).parents[2]
    for name in names:
        bare = ModuleType(f"{root.name}.{name}")
        bare.__path__ = [str(root / name)]
        sys.modules[bare.__name__] = bare


if __name__ == "__main__":
    _bare_packages("recording", "untrusted")
    from tracking.recording.bags.bag_program import main

    main(sys.stdin.buffer, sys.stdout.buffer)
