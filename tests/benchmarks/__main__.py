"""Measure the project's speed: `python -m tests.benchmarks [--only GROUP] [--json]`."""

from __future__ import annotations

import argparse
import json
import os
import sys
from importlib import import_module
from typing import Any

from tests.benchmarks.page_texts import table, told

GROUPS = (
    "pipeline",
    "filter",
    "trackers",
    "scoring",
    "session",
    "timeline",
    "window",
    "parts",
    "spheroid",
    "flow",
    "formats",
    "memory",
)

MODULES = {
    "scoring": "scorers",
    "trackers": "tracker_peers.comparison",
    "parts": "parts.speed",
    "spheroid": "spheroid_speed",
    "flow": "flow_speed",
}
"""Groups measured by a module of another name."""


def main() -> None:
    """Print the figures of each group; everything runs on one core.

    How far it is goes to standard error.
    A figure called `vs_` is our time over a peer's in the same run; null without the peer.
    """
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=__doc__)
    parser.add_argument("--only", metavar="GROUP", help=", ".join(GROUPS))
    parser.add_argument("--json", action="store_true", help="one JSON document instead of a table")
    asked = parser.parse_args()
    if asked.only not in (None, *GROUPS):
        sys.exit(f"trackwright: no benchmark {asked.only!r}; choose one of {', '.join(GROUPS)}")
    for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[variable] = "1"
    figures: dict[str, Any] = {}
    for group in [asked.only] if asked.only else GROUPS:
        measure = import_module(f"tests.benchmarks.{MODULES.get(group, group)}").measure
        with told(group):
            figures[group] = measure()
        if not asked.json:
            print(table(group, measure.__doc__, figures[group]), flush=True)
    if asked.json:
        print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
