"""Detections handed to trackers of others, and what they make of them.

Runs in the peers' environments too: it needs NumPy and nothing of this project.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from sequences import by_frame, read_tables, write_tables

SEEN = ("frame", "left", "top", "width", "height", "x", "y", "merged")
"""Of a detection; frames and pixels from 0, metres on the floor; 1 where a region may be several
people's. Clips are {name: (frames, frames a second, (n, 8) by `SEEN`, sorted by frame)}."""

FOLLOWED = ("frame", "track", "x", "y")
"""Of a row that a tracker gives."""
write_followed, read_followed = write_tables, read_tables


def follow(start, seen, frames, fps, settings):
    """One tracker over one clip: rows and the seconds of processor time that each frame took.

    What it takes to set the tracker up is left out.

    Args:
        start: (settings, frames a second) -> a function that takes a frame's number and its
            detections (k, 8) and gives pairs of an id, anything hashable, and a place (x, y).
    """
    if not settings["with_merged"]:
        seen = seen[seen[:, 7] == 0]
    numbers, rows, taken = {}, [], []
    step = start(settings, fps)
    for frame, given in enumerate(by_frame(seen, frames)):
        begun = time.process_time()
        for name, (x, y) in step(frame, given):
            rows.append((frame, numbers.setdefault(name, len(numbers) + 1), float(x), float(y)))
        taken.append(time.process_time() - begun)
    return np.array(rows).reshape(-1, len(FOLLOWED)), np.array(taken)


def main(starts):
    """Run trackers as asked on the command line: `DETECTIONS RESULTS [[NAME, SETTINGS], ...]`.

    Args:
        starts: what to start (see `follow`) by its name.
    """
    clips = read_tables(sys.argv[1])
    results = [
        {
            name: follow(starts[tracker], seen, frames, fps, settings)
            for name, (frames, fps, seen) in clips.items()
        }
        for tracker, settings in json.loads(sys.argv[3])
    ]
    write_tables(sys.argv[2], results)
