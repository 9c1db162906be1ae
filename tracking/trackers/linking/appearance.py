"""The appearance of tracklets, weighed by how well it tells people apart in this recording.

Tracklets are compared by the log-likelihood ratio of probabilistic linear discriminant analysis (S.
Ioffe: Probabilistic Linear Discriminant Analysis, 2006). Where we differ: it is weakened and
bounded.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.linking.seen_rows import Floats, SeenRows
from tracking.trackers.linking.tracklets import Tracklets

_WINDOW_S = 0.5
"""Appearance averaged over so long differs by pose and place, no longer by noise."""
_SAME, _DIFFERENT = 3.0, 6.0
"""Expected spread of CIELAB colours of one person's windows, and between people."""
_SAME_M, _DIFFERENT_M = 0.06, 0.06
"""The same of heights."""
_SAME_EMBEDDING, _DIFFERENT_EMBEDDING = 0.08, 0.25
"""The same of embeddings of unit length, along an axis in which tracks differ."""
_PRIOR_WINDOWS, _PRIOR_PEOPLE = 20.0, 1.0
"""What is expected counts like so many that are measured."""
_FEW = 3.0
"""A tracklet of so many rows is twice as unsure as a long one."""
_TRUSTED = 0.6
"""Appearance changes with light and place in ways that windows of one tracklet do not tell."""
_BIAS = 0.7
"""Part of the expected spread that windows of one track do not show: light, range, what hides."""
_HALF_OCCLUDED = 0.2
"""How much clothes of people half hidden tell, of what those of people in full sight do."""
_MISTAKEN = 3e-4
"""How often the appearance is somebody else's, seen through or beside the person."""


@dataclass(frozen=True, slots=True)
class TrackletAppearance:
    """What tells people apart in a recording, as independent normal cues of unit spread.

    Attributes:
        weight: (t, cues) of each tracklet, 1 / variance; 0: nothing is known.
        value: (t, cues) measured, times `weight`.
        between: (cues,) variance between people, where that of one person is 1.
    """

    weight: Floats
    value: Floats
    between: Floats

    def log_likelihood(self, weight: Floats, value: Floats) -> Floats:
        """(k,) log-likelihood of sums of tracklets as one person's each, up to a constant."""
        scale = 1.0 + self.between * weight
        each = -0.5 * np.log(scale) + 0.5 * self.between * np.square(value) / scale
        return np.asarray(each.sum(axis=-1))

    def log_likelihood_ratio(
        self, one: tuple[Floats, Floats], other: tuple[Floats, Floats]
    ) -> Floats:
        """(k,) log-likelihood ratio: one person's appearance rather than that of two people.

        Args:
            one, other: (k, cues) sums of `weight` and of `value` over tracklets.
        """
        ratio = self.log_likelihood(one[0] + other[0], one[1] + other[1])
        ratio = ratio - self.log_likelihood(*one) - self.log_likelihood(*other)
        trusted = np.log1p(-_MISTAKEN) + _TRUSTED * ratio
        return np.asarray(np.logaddexp(trusted, np.log(_MISTAKEN)))


def learn_appearance(seen: SeenRows, pieces: Tracklets, fps: float) -> TrackletAppearance:
    """Learn what tells the people of this recording apart, and the appearance of each tracklet.

    How far one person's appearance spreads is learnt from windows along the same tracks, of which
    few change hands; how far people differ, from whole tracks: where all wear the same, colours
    tell next to nothing. Colours are cues together, as light changes all of them alike; height is
    one of its own, and so are the embeddings of an appearance network where there is one. What
    shows of the clothes of people half hidden tells less, but in a crowd it may be all there is.
    """
    window = np.round(seen.frame / fps / _WINDOW_S).astype(np.int64)
    clothes, tall = seen.appearance[:, :6], seen.appearance[:, 6:]
    colours = _cues(seen, pieces, window, (clothes, seen.glimpsed), (_SAME, _DIFFERENT))
    unseen = np.full_like(tall, np.nan)
    height = _cues(seen, pieces, window, (tall, unseen), (_SAME_M, _DIFFERENT_M))
    cues = [colours, height]
    if seen.embedding.shape[1]:
        given = seen.embedding, np.full_like(seen.embedding, np.nan)
        cues.append(_cues(seen, pieces, window, given, (_SAME_EMBEDDING, _DIFFERENT_EMBEDDING)))
    return TrackletAppearance(
        *(np.concatenate(parts, axis=-1) for parts in zip(*cues, strict=True))
    )


def _cues(
    seen: SeenRows,
    pieces: Tracklets,
    window: NDArray[np.int64],
    appearance: tuple[Floats, Floats],
    usual: tuple[float, float],
) -> tuple[Floats, Floats, Floats]:
    """`TrackletAppearance` of some columns.

    Args:
        appearance: (n, k) in full sight, and half hidden. usual: expected spread of one person's
            windows, and between people.
    """
    same, different = usual
    known = np.isfinite(appearance[0]).all(axis=1)
    clear, piece = appearance[0][known], pieces.of_rows[known]
    track = np.unique(seen.track[known], return_inverse=True)[1]
    names, number = np.unique(np.stack((track, window[known])), axis=1, return_inverse=True)
    each = _means(clear, number.ravel(), names.shape[1])
    level = _medians(each, names[0])
    within = _spread(each - level[names[0]], _PRIOR_WINDOWS, same)
    within += np.eye(clear.shape[1]) * (_BIAS * same) ** 2
    centre = np.median(level, axis=0) if len(level) else np.zeros(clear.shape[1])
    between = _spread(level - centre, _PRIOR_PEOPLE, different)
    variance, axes = _common_axes(within, between)
    weight, value = _weighed_medians((clear - centre) @ axes, piece, len(pieces))
    half = np.isfinite(appearance[1]).all(axis=1)
    more = _weighed_medians(
        (appearance[1][half] - centre) @ axes, pieces.of_rows[half], len(pieces)
    )
    return weight + _HALF_OCCLUDED * more[0], value + _HALF_OCCLUDED * more[1], variance


def _weighed_medians(values: Floats, piece: NDArray[np.intp], pieces: int) -> tuple[Floats, Floats]:
    """The weight of each tracklet, and its median times that, (pieces, k), of values (n, k)."""
    count = np.bincount(piece, minlength=pieces).astype(float)
    middle = np.zeros((pieces, values.shape[1]))
    middle[count > 0] = _medians(values, piece)
    weight = np.repeat((count / (count + _FEW))[:, None], values.shape[1], axis=1)
    return weight, weight * middle


def _means(values: Floats, group: NDArray[np.intp], groups: int) -> Floats:
    """(groups, k) the mean of each group's values (n, k); none is empty."""
    count = np.bincount(group, minlength=groups)
    total = np.stack([np.bincount(group, column, groups) for column in values.T], axis=1)
    return np.asarray(total / count[:, None])


def _medians(values: Floats, group: NDArray[np.intp]) -> Floats:
    """(groups, k) the median of each group's values (n, k); groups stand in order, none empty."""
    parts = np.split(values, np.flatnonzero(np.diff(group)) + 1)
    return np.array([np.median(part, axis=0) for part in parts if len(part)]).reshape(
        -1, values.shape[1]
    )


def _spread(misses: Floats, prior: float, expected: float) -> Floats:
    """Covariance (k, k) of misses (n, k), drawn to what is expected; outliers count less."""
    scale = np.square(misses).mean(axis=1, keepdims=True) if len(misses) else np.ones((0, 1))
    usual = max(float(np.median(scale)) if len(misses) else 0.0, 1e-12)
    weight = 1.0 / np.maximum(1.0, scale / (4.0 * usual))
    total = (misses * weight).T @ misses + prior * expected**2 * np.eye(misses.shape[1])
    return np.asarray(total / (prior + weight.sum()))


def _common_axes(within: Floats, between: Floats) -> tuple[Floats, Floats]:
    """Axes (k, k), as columns, along which one person's spread is 1 and people's independent."""
    spread, turn = np.linalg.eigh(within)
    whitened = turn / np.sqrt(spread)
    variance, again = np.linalg.eigh(whitened.T @ between @ whitened)
    return np.maximum(variance, 0.0), whitened @ again
