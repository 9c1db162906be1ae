"""The scenarios that scenes name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType

from tracking.errors import SettingsError
from tracking.synthesis import marks, situations
from tracking.synthesis.scenario import Scenario
from tracking.synthesis.specs import SceneSpec

_FIXED: Mapping[str, Callable[[], Scenario]] = MappingProxyType(
    {
        "marks": marks.standing,
        "marks-walking": marks.walking,
        "marks-pairs": marks.pairs,
    }
)
_VARIED: Mapping[str, Callable[[int], Scenario]] = MappingProxyType(
    {
        "situations": situations.situations,
        **{
            f"situation-{n}": partial(situations.situation, n)
            for n in range(1, situations.COUNT + 1)
        },
    }
)
"""Another seed is another way of doing the same."""


def scenario_of(spec: SceneSpec, people: int, seed: int) -> Scenario:
    """The scenario that a scene follows.

    Raises:
        SettingsError: it is not for so many people.
    """
    fixed = _FIXED.get(spec.scenario)
    scenario = fixed() if fixed else _VARIED[spec.scenario](seed)
    if people != len(scenario.roles):
        raise SettingsError(
            f"people is {people}; the scene {spec.name} is for {len(scenario.roles)}, leave it out"
        )
    return scenario
