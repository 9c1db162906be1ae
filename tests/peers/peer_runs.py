"""Detections handed to trackers of others, and what they make of them.

Runs in the peers' environments too: it needs NumPy and nothing of this project.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np

SEEN = ("frame", "left", "top", "width", "height", "x", "y", "merged")
"""Of a detection; frames and pixels from 0, metres on the floor; 1 where a region may be several
people's."""

FOLLOWED = ("frame", "track", "x", "y")
"""Of a row that a tracker gives."""


def write_detections(path, clips):
    """Write {name: (frames, frames a second, (n, 8) by `SEEN`, sorted by frame)}."""
    names = list(clips)
    arrays = {f"{at}/seen": np.asarray(clips[name][2], float) for at, name in enumerate(names)}
    told = json.dumps([(name, int(clips[name][0]), float(clips[name][1])) for name in names])
    with Path(path).open("wb") as stream:
        np.savez(stream, clips=np.array(told), **arrays)


def read_detections(path):
    """Read what `write_detections` wrote."""
    with np.load(path, allow_pickle=False) as archive:
        return {
            name: (frames, fps, archive[f"{at}/seen"].reshape(-1, len(SEEN)))
            for at, (name, frames, fps) in enumerate(json.loads(str(archive["clips"])))
        }


def write_followed(path, results):
    """Write {name: ((n, 4) by `FOLLOWED`, (frames,) seconds of processor time)}, a list of such."""
    names = [list(one) for one in results]
    arrays = {
        f"{number}/{at}": np.asarray(one[name][0], float).reshape(-1, len(FOLLOWED))
        for number, one in enumerate(results)
        for at, name in enumerate(one)
    }
    seconds = {
        f"{number}/{at}/seconds": np.asarray(one[name][1], float)
        for number, one in enumerate(results)
        for at, name in enumerate(one)
    }
    with Path(path).open("wb") as stream:
        np.savez(stream, names=np.array(json.dumps(names)), **arrays, **seconds)


def read_followed(path):
    """Read what `write_followed` wrote."""
    with np.load(path, allow_pickle=False) as archive:
        return [
            {
                name: (archive[f"{number}/{at}"], archive[f"{number}/{at}/seconds"])
                for at, name in enumerate(one)
            }
            for number, one in enumerate(json.loads(str(archive["names"])))
        ]


def follow(start, seen, frames, fps, settings):
    """One tracker over one clip: rows and the seconds of processor time that each frame took.

    What it takes to set the tracker up is left out.

    Args:
        start: (settings, frames a second) -> a function that takes a frame's number and its
            detections (k, 8) and gives pairs of an id, anything hashable, and a place (x, y).
    """
    if not settings["with_merged"]:
        seen = seen[seen[:, 7] == 0]
    at = np.searchsorted(seen[:, 0], np.arange(frames + 1))
    numbers, rows, taken = {}, [], []
    step = start(settings, fps)
    for frame in range(frames):
        begun = time.process_time()
        for name, (x, y) in step(frame, seen[at[frame] : at[frame + 1]]):
            rows.append((frame, numbers.setdefault(name, len(numbers) + 1), float(x), float(y)))
        taken.append(time.process_time() - begun)
    return np.array(rows).reshape(-1, len(FOLLOWED)), np.array(taken)


def main(starts):
    """Run trackers as asked on the command line: `DETECTIONS RESULTS [[NAME, SETTINGS], ...]`.

    Args:
        starts: what to start (see `follow`) by its name.
    """
    clips = read_detections(sys.argv[1])
    write_followed(
        sys.argv[2],
        [
            {
                name: follow(starts[tracker], seen, frames, fps, settings)
                for name, (frames, fps, seen) in clips.items()
            }
            for tracker, settings in json.loads(sys.argv[3])
        ],
    )
