"""What an appearance network says of people while they are tracked, kept for linking."""

from __future__ import annotations

import numpy as np

from tracking.people.appearance_source import Embed, Embeddings
from tracking.trackers import StepResult
from tracking.tracks import EMBEDDING_COLUMNS, Columns, empty
from tracking.tracks.columns import EMBEDDING_PART, boxes_of

_EVERY_S = 0.5
"""Linking compares windows of so long; embeddings of consecutive frames tell the same."""
_WELL_SEEN = 0.5
"""Visibility from which on a crop shows this person rather than whoever is in front."""


class TrackEmbeddings:
    """Describes each track now and then, where it is seen well.

    Args:
        embed: of the picture that was tracked last.
    """

    def __init__(self, embed: Embed) -> None:
        self._embed = embed
        self._next_s: dict[int, float] = {}

    def rows(self, result: StepResult, time_s: float) -> Columns:
        """`EMBEDDING_COLUMNS` of a step."""
        tracks = result.tracks
        seen = ~tracks["predicted"] & (tracks["visibility"] >= _WELL_SEEN)
        due = np.array([time_s >= self._next_s.get(t, -np.inf) for t in tracks["track"].tolist()])
        rows = np.flatnonzero(seen & due.astype(bool).reshape(seen.shape))
        if not len(rows):
            return empty(EMBEDDING_COLUMNS)
        embeddings = self._embed(boxes_of(tracks, rows))
        known = np.isfinite(embeddings).all(axis=1) & (embeddings.shape[1] > 0)
        here = tracks["track"][rows[known]]
        self._next_s |= dict.fromkeys(here.tolist(), time_s + _EVERY_S - 1e-3)
        return embedding_columns(result.frame, here, embeddings[known])


def embedding_columns(frame: int, track: np.ndarray, embeddings: Embeddings) -> Columns:
    """Embeddings (n, d) of tracks (n,) as rows of `EMBEDDING_PART` numbers, zeros at the end."""
    count, width = embeddings.shape
    parts = -(-width // EMBEDDING_PART)
    padded = np.zeros((count, parts * EMBEDDING_PART), np.float16)
    padded[:, :width] = embeddings
    values = padded.reshape(-1, EMBEDDING_PART)
    names = [name for name in EMBEDDING_COLUMNS if name.startswith("v")]
    return {
        "frame": np.full(len(values), frame, np.int32),
        "track": np.repeat(track, parts).astype(np.int32),
        "part": np.tile(np.arange(parts, dtype=np.uint16), count),
        **dict(zip(names, np.ascontiguousarray(values.T), strict=True)),
    }
