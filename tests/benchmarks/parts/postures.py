"""What becomes of people who crouch or bend and stand up again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from tests.benchmarks.parts.clips import FPS, Clip
from tracking.scoring.parts import Judged

STANDS_AGAIN_S = 1.0
"""How long after standing up the parts may take to be right again."""

_STOOPS = 0.05
_SETTLED_FRAMES = 10  # how long a person must be followed before going down


@dataclass(frozen=True, slots=True)
class Stoop:
    """One time that somebody who was tracked went down.

    Attributes:
        person: true id.
        bent: bent over; else crouched.
        kept: the same track stands on the person a second after standing up.
        recovered_s: from standing up until all three parts were right; inf where they were not
            within the time the person stayed in view.
    """

    person: int
    bent: bool
    kept: bool
    recovered_s: float


def stoops_in(clip: Clip, judged: Sequence[Judged]) -> list[Stoop]:
    """All stoops of a clip that began and ended while the person was judged."""
    cast = clip.cast()
    found = []
    for one in judged:
        walk, stoops = cast.walks[one.person - 1], cast.stoops[one.person - 1]
        if walk is None or stoops is None:
            continue
        for bent, depth in ((False, stoops.crouch), (True, stoops.bend)):
            for start, end in _spans(depth > _STOOPS):
                rows = walk.first_frame + start, walk.first_frame + end
                found += _followed(one, bent, *rows)
    return found


def _followed(one: Judged, bent: bool, down: int, up: int) -> Iterable[Stoop]:
    """The stoop from frame `down` to `up`, if the person was judged before and after it."""
    first, last = down - one.first_frame, up - one.first_frame
    later = last + round(STANDS_AGAIN_S * FPS)
    if first < _SETTLED_FRAMES or later >= len(one.parts):
        return
    again = np.flatnonzero(one.parts[last:].all(axis=1))
    recovered = float(again[0]) / FPS if len(again) else np.inf
    yield Stoop(one.person, bent, bool(one.person_right[later]), recovered)


def _spans(there: np.ndarray) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate(([0], there.astype(int), [0]))))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))
