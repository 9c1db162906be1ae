"""Tables handed to other programs and back: nested lists and dictionaries with arrays, in a file.

Runs in the peers' environments too: it needs NumPy and nothing of this project.
"""

import itertools
import json
from pathlib import Path

import numpy as np

COLUMNS = ("frame", "track", "left", "top", "width", "height", "x", "y", "confidence")
"""Of a row; frames and pixels from 0, metres on the floor; in the truth confidence 0 marks a
don't-care. Sequences are {name: (truth, result)}, each (n, 9), sorted by frame."""


def write_tables(path, content):
    """Write lists, tuples, dictionaries, texts, numbers and arrays as a NumPy archive."""
    arrays = []

    def referring(array):
        arrays.append(array)
        return {"array": len(arrays) - 1}

    told = json.dumps(content, default=referring)
    with Path(path).open("wb") as stream:
        np.savez(stream, *arrays, content=np.array(told))


def read_tables(path):
    """Read what `write_tables` wrote; tuples come back as lists."""

    def array_of(found):
        return archive[f"arr_{found['array']}"] if found.keys() == {"array"} else found

    with np.load(path, allow_pickle=False) as archive:
        return json.loads(str(archive["content"]), object_hook=array_of)


write_sequences = write_tables


def by_frame(rows, frames):
    """The rows of each frame from 0 on, in their order; a row begins with its frame."""
    at = np.searchsorted(rows[:, 0], np.arange(frames + 1))
    return [rows[begin:end] for begin, end in itertools.pairwise(at.tolist())]
