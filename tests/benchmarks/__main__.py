"""Measure the project's speed: `python -m tests.benchmarks [--only GROUP] [--json]`."""

from __future__ import annotations

import argparse
import json
import sys
from importlib import import_module
from typing import Any

from tests.benchmarks.command import one_core, telling
from tests.benchmarks.tables import table

GROUPS = {
    "pipeline": "pipeline.measure",
    "pipeline_720p": "pipeline.pipeline_720p",
    "two_processes": "two_processes.measure",
    "filter": "filter.measure",
    "scoring": "scorers.measure",
    "session": "session.measure",
    "window": "window.measure",
    "parts": "pipeline.parts",
    "spheroid": "pipeline.spheroid",
    "flow": "pipeline.flow",
}
"""The function that measures each group."""


def main() -> None:
    """Print the figures of each group; every process runs on one core.

    How far it is goes to standard error.
    A figure called `vs_` is our time over a peer's in the same run; null without the peer.
    """
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=__doc__)
    parser.add_argument("--only", metavar="GROUP", help=", ".join(GROUPS))
    parser.add_argument("--json", action="store_true", help="one JSON document instead of a table")
    asked = parser.parse_args()
    if asked.only not in (None, *GROUPS):
        sys.exit(f"trackwright: no benchmark {asked.only!r}; choose one of {', '.join(GROUPS)}")
    one_core()
    figures: dict[str, Any] = {}
    for group in [asked.only] if asked.only else GROUPS:
        module, _, name = GROUPS[group].partition(".")
        measure = getattr(import_module(f"tests.benchmarks.{module}"), name)
        with telling(group):
            figures[group] = measure()
        if not asked.json:
            print(table(group, measure.__doc__, figures[group]), flush=True)
    if asked.json:
        print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
