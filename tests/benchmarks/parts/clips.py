"""The rendered clips on which body parts are measured; the left camera of each."""

from __future__ import annotations

from collections.abc import Iterable

from tests.benchmarks.clips import Clip
from tests.benchmarks.parts.scenes import ELSEWHERE


def _clips(scene: str, seeds: Iterable[int]) -> tuple[Clip, ...]:
    return tuple(Clip(scene, seed, cameras=1) for seed in seeds)


def _elsewhere(*seeds: int) -> tuple[Clip, ...]:
    return tuple(clip for scene in ELSEWHERE for clip in _clips(scene, seeds))


REPORTED = _clips("walkway", range(4301, 4321))
"""20 clips, 100 people, on which nothing was trained or chosen."""

REPORTED_CROUCHING = _clips("crouching", range(4351, 4357))

REPORTED_ELSEWHERE = _elsewhere(4391)
"""People as other cameras see them: for the detector alone."""

TRAINED_PAPER = (
    *_clips("walkway", range(4111, 4129)),
    *_clips("crouching", range(4161, 4166)),
    *_elsewhere(4142, 4143),
)
"""The built-in detector that sees the paper's features alone learns from these."""

TRAINED = (
    *_clips("walkway", range(4111, 4117)),
    *_clips("hall", (4142, 4143)),
    *_clips("court", (4142, 4143)),
    *_clips("car-park", (4142,)),
    *_clips("street", (4142,)),
    *_clips("pavement", (4142,)),
)
"""The built-in detector with evidence learns from these: it needs fewer, as evidence means the
same in any camera."""

CHECKED = (
    *_clips("walkway", range(4171, 4175)),
    *_clips("crouching", (4181,)),
    *_elsewhere(4191),
)
"""What the detector learns from, and how, was chosen by these."""

TUNED = _clips("walkway", range(4101, 4105))
"""For choosing settings of trackers: neither learnt from nor reported on."""

TUNED_CROUCHING = _clips("crouching", range(4151, 4153))


def title_of(clip: Clip) -> str:
    """A clip in figures and in the detector's file."""
    return f"{clip.scene} {clip.seed}"
