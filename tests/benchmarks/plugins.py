"""What installed plug-ins cost at the start: `python -m tests.benchmarks.plugins`.

Each of the packages takes long to import and leaves a mark where it is. Starts with and without
them alternate, in processes of their own; the difference of the medians is told.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from tests.installed_plugins import install_module
from tracking.plugins import PluginKind

_PACKAGES, _ROUNDS = 50, 15
_CODE = "import time; time.sleep(0.5); open(__file__ + '.imported', 'w').close(); {name} = None\n"
_STARTS: Mapping[str, Sequence[str]] = {
    "help": ("-m", "app", "--help"),
    "names": ("-c", "from tracking.trackers import TRACKERS; TRACKERS.names"),
    "window": (
        "-c",
        "import app.shell.main_window; from tracking.trackers import TRACKERS; TRACKERS.names",
    ),
}
"""What is started."""


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--packages", type=int, default=_PACKAGES)
    parser.add_argument("--rounds", type=int, default=_ROUNDS)
    parser.add_argument("--json", action="store_true")
    asked = parser.parse_args()
    found = measure(asked.packages, asked.rounds)
    if asked.json:
        print(json.dumps(found, indent=2))
        return
    for start, figures in found.items():
        print(
            f"{start:8} {figures['without_ms']:7.0f} ms without, {figures['with_ms']:7.0f} ms with "
            f"{asked.packages} plug-ins: {figures['cost_ms']:+.1f} ms, "
            f"{figures['imported']:.0f} imported"
        )


def measure(packages: int, rounds: int) -> dict[str, dict[str, float]]:
    """Medians of the processor's time of starts, ms, with and without plug-ins installed."""
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder) / "site"
        for number in range(packages):
            kind = list(PluginKind)[number % len(PluginKind)]
            name = f"plugin-{number}"
            points = {(kind.group, name): kind.value.upper()}
            install_module(site, name, _CODE.format(name=kind.value.upper()), points)
        found = {}
        for start, words in _STARTS.items():
            spent: dict[bool, list[float]] = {True: [], False: []}
            for number in range(2 * rounds + 2):
                there = number % 2 == 0
                taken = _start(words, site if there else None)
                if number >= 2:  # the first ones read everything from the disk
                    spent[there].append(taken)
            with_ms, without_ms = (statistics.median(spent[there]) for there in (True, False))
            found[start] = {
                "without_ms": without_ms,
                "with_ms": with_ms,
                "cost_ms": with_ms - without_ms,
                "imported": float(len(list(site.glob("*.imported")))),
            }
    return found


def _start(words: Sequence[str], site: Path | None) -> float:
    """Milliseconds of processor that a start takes."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "QT_QPA_PLATFORM": "offscreen"}
    environment["PYTHONPATH"] = str(site) if site is not None else ""
    before = os.times()
    subprocess.run([sys.executable, *words], env=environment, check=True, stdout=subprocess.DEVNULL)
    after = os.times()
    children = (after.children_user + after.children_system) - (
        before.children_user + before.children_system
    )
    return 1000 * children


if __name__ == "__main__":
    main()
