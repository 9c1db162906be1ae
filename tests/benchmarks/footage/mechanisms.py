"""The mechanisms of trackers that can be left out, and what stands in their place then."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

Values = tuple[tuple[str, Any], ...]


@dataclass(frozen=True, slots=True)
class Mechanism:
    """A part of a tracker that can be left out.

    Attributes:
        name: in tables.
        what: it does, in a few words.
        settings: with which the tracker does without it.
        replaced: module-level values of the library, and what stands in their place; see
            `Case.replaced`.
    """

    name: str
    what: str
    settings: Values = ()
    replaced: Values = ()


_HERE = __name__
_SPHEROID = "tracking.trackers.spheroid"


def no_ghosts(_flat: Any, outlines: Any, *_: Any) -> Any:
    """Nobody is a ghost."""
    return np.zeros(len(outlines), bool)


def no_split(people: Any, *_: Any) -> Any:
    """Nobody is two people."""
    return people, np.zeros((0, 4))


def same_people(people: Any, *_: Any) -> Any:
    """The people as they are."""
    return people


MECHANISMS: Mapping[str, tuple[Mechanism, ...]] = {
    "spheroid": (
        Mechanism(
            "ghosts",
            "deletes tracks whose outline has edges in the background only",
            replaced=((f"{_SPHEROID}.ghosts.are_ghosts", f"{_HERE}.no_ghosts"),),
        ),
        Mechanism(
            "split merged",
            "finds the second of two people followed as one",
            replaced=((f"{_SPHEROID}.split_merged.split_merged", f"{_HERE}.no_split"),),
        ),
        Mechanism("colours", "colours weigh hypotheses", settings=(("colour_weight", 0.0),)),
        Mechanism(
            "heights",
            "body heights are estimated",
            replaced=((f"{_SPHEROID}.filter_steps.learn_heights", f"{_HERE}.same_people"),),
        ),
    ),
}
