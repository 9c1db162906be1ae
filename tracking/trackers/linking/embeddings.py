"""What an appearance network says of a run's tracks, in the few numbers that tell them apart.

Principal components of the tracks' means: as many directions as linking can learn the spread of.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats, Integers
from tracking.tracks.columns import EMBEDDING_COLUMNS, EMBEDDING_PART, Columns
from tracking.tracks.row_keys import row_keys

_MOST_AXES = 6
"""As many as clothes have: no cue outweighs the others by the length of its vector."""


def embeddings_of_rows(embeddings: Columns, frame: Integers, track: Integers, use: Flags) -> Floats:
    """(rows, axes) embeddings of rows in the axes of the run; NaN where there is none.

    Args:
        embeddings: `EMBEDDING_COLUMNS`. frame, track: (rows,) of rows. use: (rows,) whether what
            is seen there is this person.
    """
    if not len(embeddings["frame"]) or not len(frame):
        return np.zeros((len(frame), 0))
    key, vectors = _vectors(embeddings)
    own = row_keys(track, frame)
    order = np.argsort(own)
    at = order[np.minimum(np.searchsorted(own[order], key), len(own) - 1)]
    hit = (own[at] == key) & use[at]
    reduced = _on_axes(vectors[hit], track[at[hit]])
    rows = np.full((len(frame), reduced.shape[1]), np.nan)
    rows[at[hit]] = reduced
    return rows


def _vectors(embeddings: Columns) -> tuple[NDArray[np.int64], Floats]:
    """The row keys (n,) of embeddings, and themselves (n, d)."""
    parts = int(embeddings["part"].max()) + 1
    names = [name for name in EMBEDDING_COLUMNS if name.startswith("v")]
    table = np.stack([embeddings[name] for name in names], axis=1).astype(np.float64)
    first = embeddings["part"] == 0
    key = row_keys(embeddings["track"][first], embeddings["frame"][first])
    return key, table.reshape(len(key), parts * EMBEDDING_PART)


def _on_axes(vectors: Floats, track: Integers) -> Floats:
    """The vectors (n, d) along the axes (n, k) in which the means of tracks differ most."""
    names, number = np.unique(track, return_inverse=True)
    axes = min(_MOST_AXES, len(names) - 1, vectors.shape[1])
    if axes < 1:
        return np.zeros((len(vectors), 0))
    mean = np.zeros((len(names), vectors.shape[1]))
    np.add.at(mean, number, vectors)
    mean /= np.bincount(number)[:, None]
    centre = mean.mean(axis=0)
    _, _, along = np.linalg.svd(mean - centre, full_matrices=False)
    return np.asarray((vectors - centre) @ along[:axes].T)
