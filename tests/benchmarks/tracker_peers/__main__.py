"""Our trackers beside others': `python -m tests.benchmarks.tracker_peers [RECORDING...] [--json]`.

On crossing walkers, or on what our perception sees of recordings with truth.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from tests.benchmarks.tracker_peers.comparison import OURS, compared, compared_on
from tests.benchmarks.tracker_peers.rendered_clips import rendered_clip
from tests.benchmarks.tracker_peers.report import as_json, markdown


def main() -> None:
    """Print the table, or JSON."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.tracker_peers")
    parser.add_argument("recordings", nargs="*", type=Path, help="instead of crossing walkers")
    parser.add_argument("--ours", nargs="+", default=list(OURS), help="of our trackers")
    parser.add_argument("--seeds", nargs="+", type=int, help="of the crossing walkers")
    parser.add_argument("--json", action="store_true", help="JSON instead of a table")
    asked = parser.parse_args()
    if asked.recordings:
        clips = [rendered_clip(folder) for folder in asked.recordings]
        rows = compared_on(clips, "rendered", asked.ours)
    else:
        rows = compared(asked.seeds, asked.ours) if asked.seeds else compared(ours=asked.ours)
    print(json.dumps(as_json(rows), indent=2) if asked.json else markdown(rows), end="")


if __name__ == "__main__":
    main()
