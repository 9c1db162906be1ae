"""Who tracks are by an appearance network: one more cue of association, beside colours.

The cosine distance between the mean embedding of a track and a detection is taken as normally
distributed, with one mean for measurements of one person and another one for two people, both
learnt in the footage, and one spread: the log-likelihood ratio is that of linear discriminant
analysis.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.people.appearance_source import Embeddings

_SAME, _OTHER, _SPREAD = 0.2, 0.5, 0.12
"""Means and spread of cosine distances until learnt, as usual networks have them."""
_WORTH = 50.0
"""Comparisons those are worth."""
_MEMORY = 4000.0
"""Comparisons that count."""
_NOTHING = 0.02
"""Share of crops that say nothing, as of people partly covered: what bounds the ratio."""
_LOOKS = 50.0
"""Looks that a track's mean is of; later ones count for more."""
_MOST_TRACKS = 2000
"""Tracks that are remembered; those seen last stay."""


@dataclass(frozen=True, slots=True)
class DistanceModel:
    """Sums over comparisons: (2,) of one person, and of two people.

    Attributes:
        count: of comparisons. total: of distances. squares: of their squares about the mean.
    """

    count: Floats
    total: Floats
    squares: Floats

    @classmethod
    def prior(cls) -> DistanceModel:
        """What is expected before anything was compared."""
        count = np.full(2, _WORTH)
        return cls(count, count * (_SAME, _OTHER), count * _SPREAD**2)

    def update(self, same: Floats, other: Floats) -> DistanceModel:
        """With more distances (n,) within people and between them."""
        mean = self.total / self.count
        both = (same[np.isfinite(same)], other[np.isfinite(other)])
        count = self.count + [len(each) for each in both]
        total = self.total + [each.sum() for each in both]
        squares = self.squares + [
            np.square(each - middle).sum() for each, middle in zip(both, mean, strict=True)
        ]
        faded = np.minimum(1.0, _MEMORY / count)
        return DistanceModel(count * faded, total * faded, squares * faded)

    def log_likelihood_ratio(self, distance: Floats) -> Floats:
        """That of one person against two people; bounded, 0 where nothing is known."""
        same, other = self.total / self.count
        variance = float(self.squares.sum() / self.count.sum())
        gap = max(float(other - same), 0.0)  # networks that tell nobody apart say nothing
        middle = float(same + other) / 2
        ratio = gap / variance * (middle - np.where(np.isnan(distance), middle, distance))
        nothing = np.log(_NOTHING)
        return np.asarray(np.logaddexp(ratio, nothing) - np.logaddexp(0.0, ratio + nothing))


class KnownEmbeddings:
    """The mean embedding of each track by its id, learnt while people are tracked."""

    def __init__(self) -> None:
        """Nobody is known yet."""
        self._mean: dict[int, NDArray[np.float64]] = {}
        self._looks: dict[int, int] = {}
        self._model = DistanceModel.prior()

    def log_likelihood_ratio(
        self, track: NDArray[np.integer], embeddings: Embeddings | None
    ) -> Floats:
        """(tracks, detections) how much speaks for each being that person, in nats.

        Args:
            track: ids; 0 of tentative tracks, of which nothing is known.
            embeddings: (detections, d), NaN where unknown; d is 0 before the first usable crop.
                None: there is no network.
        """
        if embeddings is None:
            return np.zeros((len(track), 0))
        if not embeddings.shape[1]:
            return np.zeros((len(track), len(embeddings)))
        return self._model.log_likelihood_ratio(self._distances(track, embeddings))

    def learn(
        self, track: NDArray[np.integer], embeddings: Embeddings, clear: NDArray[np.bool_]
    ) -> None:
        """Take the embedding of each track (n,), of those seen clearly, and how people differ.

        Ids are of different people, who are in view together. Embeddings of no length tell nothing.
        """
        if not embeddings.shape[1]:
            return
        seen = clear & (track > 0) & np.isfinite(embeddings).all(axis=1)
        track, embeddings = track[seen], embeddings[seen]
        distance = self._distances(track, embeddings)
        own = np.eye(len(track), dtype=bool)
        self._model = self._model.update(distance[own], distance[~own])
        for each, embedding in zip(track.tolist(), embeddings, strict=True):
            looks = min(self._looks.get(each, 0) + 1, _LOOKS)
            mean = self._mean.pop(each, np.zeros(len(embedding)))
            self._mean[each] = mean + (embedding - mean) / looks
            self._looks[each] = int(looks)
        while len(self._mean) > _MOST_TRACKS:
            gone = next(iter(self._mean))
            del self._mean[gone], self._looks[gone]

    def _distances(self, track: NDArray[np.integer], embeddings: Embeddings) -> Floats:
        """(tracks, detections) cosine distances; NaN where one of them is not known."""
        unknown = np.full(embeddings.shape[1], np.nan)
        known = np.array([self._mean.get(each, unknown) for each in track.tolist()])
        known = known.reshape(len(track), embeddings.shape[1])
        length = np.maximum(np.linalg.norm(known, axis=1, keepdims=True), 1e-9)
        return np.asarray(1.0 - (known / length) @ embeddings.T.astype(np.float64))
