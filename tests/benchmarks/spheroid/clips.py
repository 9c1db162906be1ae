"""The rendered clips on which spheroids are measured."""

from __future__ import annotations

from dataclasses import dataclass

from tests.benchmarks.rendered_clips import Clip
from tracking.synthesis import Disturbances

SITUATIONS = tuple(f"situation-{number}" for number in range(1, 16))
PLACES = ("lobby", "plaza", "square", "pillars", "ceiling", "corridor")
SECONDS = 12.0
"""Of the clips that are not scenarios."""

_BEGIN_S, _LATER_S = 8.0, 6.0


@dataclass(frozen=True, slots=True)
class Clips:
    """All that one report or one round of tuning looks at.

    Attributes:
        standing, walking, pairs: on the marks ([Waechter2013] tables 1 and 2).
        situations: [Waechter2013] table 3.
        places: recorded with two cameras, so that one can be compared with both.
        peopled: begin with people in them.
        dimmed: a part of the light goes out.
        bumped: the camera is knocked.
    """

    standing: tuple[Clip, ...]
    walking: tuple[Clip, ...]
    pairs: tuple[Clip, ...]
    situations: tuple[Clip, ...]
    places: tuple[Clip, ...]
    peopled: tuple[Clip, ...]
    dimmed: tuple[Clip, ...]
    bumped: tuple[Clip, ...]


def _clips(seeds: tuple[int, ...]) -> Clips:
    first = seeds[0]
    return Clips(
        standing=tuple(Clip("marks", seed) for seed in seeds),
        walking=tuple(Clip("marks-walking", seed) for seed in seeds),
        pairs=tuple(Clip("marks-pairs", seed) for seed in seeds),
        situations=tuple(Clip(name, seed) for seed in seeds for name in SITUATIONS),
        places=tuple(Clip(name, first, SECONDS) for name in PLACES),
        peopled=tuple(
            _disturbed_clip(name, first, begin_s=_BEGIN_S) for name in ("ceiling", "plaza")
        ),
        dimmed=tuple(
            _disturbed_clip(name, first, dimmed_s=_LATER_S) for name in ("ceiling", "plaza")
        ),
        bumped=tuple(
            _disturbed_clip(name, first, bumped_s=_LATER_S) for name in ("ceiling", "plaza")
        ),
    )


def _disturbed_clip(scene: str, seed: int, **disturbances: float) -> Clip:
    return Clip(scene, seed, SECONDS, cameras=1, disturbances=Disturbances(**disturbances))


TUNED = _clips((5101,))
"""For choosing settings; never reported."""

REPORTED = _clips((5201, 5202))
"""Nothing was chosen on these."""
