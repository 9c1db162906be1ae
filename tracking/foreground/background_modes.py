"""Primary and secondary background modes of a fixed scene, from a few pictures of it.

The primary mode of a pixel is what most pictures show there, the secondary one what most of the
others do.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Picture
from tracking.foreground.difference import largest_difference
from tracking.foreground.gain import channel_ratios, scaled
from tracking.foreground.local_light import MUCH_CHANGED, change_of_light
from tracking.foreground.stillness import stillness

_Told = TypeVar("_Told")

_SAME_WITHIN = 20
_MOST_PICTURES = 25
_LASTING = 3
"""Pictures that must share a secondary mode: two people who pass may look alike by chance."""
_LASTING_SPREAD = 0.75
"""How far two of them may be from the third, together, in times of `_SAME_WITHIN`: as noise, and
light that was not quite taken out, make it. Clothes that are not the same mostly differ by more."""


_DIFFERS = 16
"""Grey levels by which a pixel is another."""
_SAME_EXPOSURE = 0.03
"""Ratios of brightness so close to 1 are noise and people."""


@dataclass(frozen=True, slots=True)
class SecondaryMode:
    """The secondary mode of the background, where there is one.

    Attributes:
        picture: (height, width, 3) uint8; the primary mode where there is no secondary one.
        where: (height, width) uint8, 255 where there is a secondary mode, else 0.
    """

    picture: Picture
    where: NDArray[np.uint8]


def primary_mode(
    pictures: Sequence[Picture], later: Sequence[Picture] = ()
) -> tuple[Picture, NDArray[np.float32]]:
    """Per pixel, the one of the pictures' values that is seen again at most other times.

    Unlike a median it needs no majority: people may cover a pixel in most pictures as long as
    they look different and the background looks the same. Values that come back after a long time
    count for more than those that stay for a while, and values count for little where something
    moves near by, so that who lingers is told from the scene. Light that changes between the
    pictures is taken out before.

    Args:
        pictures: at least one (height, width, 3) uint8, in order of time and spread evenly over it;
            more than 25 are thinned out evenly.
        later: of each the picture a moment later; empty: it is not known what moves.

    Returns:
        picture: (height, width, 3) uint8.
        deviation: (height, width) float32, mean difference of the values close to it.
    """
    _, _, best, distances = _compare(pictures, later)
    return best, _deviation(distances)


def primary_and_secondary_mode(
    pictures: Sequence[Picture], later: Sequence[Picture] = ()
) -> tuple[Picture, NDArray[np.float32], SecondaryMode]:
    """As `primary_mode`, and what is commonest among the values unlike it."""
    smooth, costs, best, distances = _compare(pictures, later)
    return best, _deviation(distances), _secondary_mode(best, smooth, costs, distances)


def _compare(
    pictures: Sequence[Picture], later: Sequence[Picture]
) -> tuple[list[Picture], list[NDArray[np.float32]], Picture, list[NDArray[np.uint8]]]:
    """The pictures in one light, their strangeness, the primary mode, and how far from it."""
    chosen = thinned(pictures)
    smooth = [np.asarray(cv2.blur(picture, (3, 3)), np.uint8) for picture in chosen]
    still = [
        stillness(picture, np.asarray(cv2.blur(after, (3, 3)), np.uint8))
        for picture, after in zip(smooth, thinned(later), strict=False)
    ]
    smooth = in_one_light(smooth)
    costs, support = _strangeness_and_support(smooth, still)
    lasting = _least(smooth, [-each for each in support])
    best = _least_strange_like(lasting, smooth, costs)
    return smooth, costs, best, [largest_difference(picture, best) for picture in smooth]


def _strangeness_and_support(
    pictures: Sequence[Picture], still: Sequence[NDArray[np.float32]]
) -> tuple[list[NDArray[np.float32]], list[NDArray[np.float32]]]:
    """How far each picture is from the others, bounded, and how much speaks for its values.

    Args:
        still: (height, width) of each picture; empty: not known.
    """
    shape = pictures[0].shape[:2]
    costs, support = ([np.zeros(shape, np.float32) for _ in pictures] for _ in range(2))
    for i, picture in enumerate(pictures):
        for k in range(i):
            apart = np.minimum(largest_difference(picture, pictures[k]), _SAME_WITHIN)
            for each in (costs[i], costs[k]):
                cv2.accumulate(apart, each)
            alike = np.float32(_SAME_WITHIN) - apart
            alike *= np.float32(i - k)
            if still:
                alike *= still[i]
                alike *= still[k]
            for each in (support[i], support[k]):
                cv2.accumulate(alike, each)
    return costs, support


def _least(pictures: Sequence[Picture], costs: Sequence[NDArray[np.float32]]) -> Picture:
    """Per pixel, the value of the picture that costs least."""
    best_cost = np.full(costs[0].shape, np.inf, np.float32)
    best = pictures[0].copy()
    for picture, cost in zip(pictures, costs, strict=True):
        better = cost < best_cost
        np.copyto(best, picture, where=better[..., None])
        np.copyto(best_cost, cost, where=better)
    return best


def _least_strange_like(
    lasting: Picture, pictures: Sequence[Picture], costs: Sequence[NDArray[np.float32]]
) -> Picture:
    """Per pixel, the most usual of the values like the one that lasts: it has the least noise."""
    like = [
        np.where(largest_difference(picture, lasting) < _SAME_WITHIN, cost, np.float32(np.inf))
        for picture, cost in zip(pictures, costs, strict=True)
    ]
    return _least(pictures, like)


def _secondary_mode(
    best: Picture,
    pictures: Sequence[Picture],
    costs: Sequence[NDArray[np.float32]],
    distances: Sequence[NDArray[np.uint8]],
) -> SecondaryMode:
    """The commonest value among those unlike the best, where several pictures share it.

    Args:
        distances: (height, width) each, of the pictures from the best.
    """
    unlike = [distance >= _SAME_WITHIN for distance in distances]
    # Nearly everywhere the scene is all there is to see: the few other places are looked at alone.
    place = np.flatnonzero(np.sum(unlike, axis=0, dtype=np.uint8) >= _LASTING)
    cost = np.stack(
        [
            np.where(other.ravel()[place], each.ravel()[place], np.float32(np.inf))
            for other, each in zip(unlike, costs, strict=True)
        ]
    )
    shared = cost.min(axis=0) <= _SAME_WITHIN * (len(pictures) - _LASTING + _LASTING_SPREAD)
    place, chosen = place[shared], cost.argmin(axis=0)[shared]
    picture, where = best.copy(), np.zeros(best.shape[:2], np.uint8)
    where.ravel()[place] = 255
    for number, other in enumerate(pictures):
        here = place[chosen == number]
        picture.reshape(-1, 3)[here] = other.reshape(-1, 3)[here]
    return SecondaryMode(picture, where)


def thinned(values: Sequence[_Told]) -> list[_Told]:
    """At most 25 of the pictures or what is told of each, spread evenly."""
    count = len(values)
    numbers = np.unique(np.linspace(0, count - 1, min(count, _MOST_PICTURES)).astype(np.intp))
    return [values[i] for i in numbers]


def _deviation(distances: Sequence[NDArray[np.uint8]]) -> NDArray[np.float32]:
    """(height, width) mean distance of the pictures that are close."""
    total = np.zeros(distances[0].shape, np.float32)
    count = np.zeros(distances[0].shape, np.uint8)
    for distance in distances:
        close = distance < _SAME_WITHIN
        cv2.accumulate(distance, total, mask=close.view(np.uint8))
        count += close
    return np.asarray(total / np.maximum(count, 1).astype(np.float32), np.float32)


def in_one_light(pictures: Sequence[Picture]) -> list[Picture]:
    """The pictures in the light of that one which is neither among the brighter nor the darker.

    Lamps that go on or off, the sun and the camera's own exposure change how the empty scene looks;
    without this, what is commonest would be one light here and another there. Pictures in the
    same light stay as they are.

    Args:
        pictures: at least one (height, width, 3).
    """
    order = np.argsort([float(picture[::8, ::8, 1].mean()) for picture in pictures], kind="stable")
    usual = pictures[int(order[len(order) // 2])]
    return [_in_light_of(usual, picture) for picture in pictures]


def _in_light_of(usual: Picture, picture: Picture) -> Picture:
    """The picture as it would be in the light of another."""
    brighter = channel_ratios(picture, usual)
    if np.abs(brighter - 1).max() > _SAME_EXPOSURE:
        picture = scaled(picture, np.float32(1) / brighter)
    differs = largest_difference(picture, usual) > _DIFFERS
    if differs.mean() < MUCH_CHANGED:
        return picture
    change = change_of_light(usual, picture, differs.view(np.uint8) * np.uint8(255))
    if change is None:
        return picture
    return np.asarray(cv2.multiply(picture, change, dtype=cv2.CV_8U), np.uint8)
