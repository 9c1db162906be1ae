"""Sequences of tracks handed to other programs: plain rows, in one file for many sequences.

Runs in the peers' environments too: it needs NumPy and nothing of this project.
"""

import itertools
import json
from pathlib import Path

import numpy as np

COLUMNS = ("frame", "track", "left", "top", "width", "height", "x", "y", "confidence")
"""Of a row; frames and pixels from 0, metres on the floor; in the truth confidence 0 marks a
don't-care."""


def write_sequences(path, sequences):
    """Write {name: (truth, result)}, each (n, 9) by `COLUMNS`, as a NumPy archive."""
    names = list(sequences)
    arrays = {}
    for number, name in enumerate(names):
        truth, result = sequences[name]
        arrays[f"{number}/truth"] = np.asarray(truth, np.float64).reshape(-1, len(COLUMNS))
        arrays[f"{number}/result"] = np.asarray(result, np.float64).reshape(-1, len(COLUMNS))
    with Path(path).open("wb") as stream:
        np.savez(stream, names=np.array(json.dumps(names)), **arrays)


def read_sequences(path):
    """Read what `write_sequences` wrote."""
    with np.load(path, allow_pickle=False) as archive:
        names = json.loads(str(archive["names"]))
        return {
            name: (archive[f"{number}/truth"], archive[f"{number}/result"])
            for number, name in enumerate(names)
        }


def by_frame(rows, frames):
    """The rows of each frame from 0 on, in their order."""
    at = np.searchsorted(rows[:, 0], np.arange(frames + 1))
    return [rows[begin:end] for begin, end in itertools.pairwise(at.tolist())]
