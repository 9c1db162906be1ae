"""Rows of a queue of people to look at."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes import Colour
from tracking.review import ReviewItemKey


@dataclass(frozen=True, slots=True)
class ReviewPerson:
    """Somebody a review item is about."""

    track: int
    label: str
    colour: Colour


@dataclass(frozen=True, slots=True)
class ReviewRow:
    """A review item in the queue.

    Attributes:
        key: what a decision on it is kept under.
        title: its kind in words, e.g. "Paths cross". when: e.g. "00:41.70".
        why: the strongest reason in words. others: further reasons.
        likelihood: 0 to 1.
    """

    key: ReviewItemKey
    title: str
    people: tuple[ReviewPerson, ...]
    frame: int
    when: str
    why: str
    others: tuple[str, ...]
    likelihood: float
