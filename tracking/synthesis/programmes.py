"""The programmes that scenes name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType

from tracking.errors import SettingsError
from tracking.synthesis import marks, situations
from tracking.synthesis.programme import Programme
from tracking.synthesis.specs import SceneSpec

_FIXED: Mapping[str, Callable[[], Programme]] = MappingProxyType(
    {
        "marks": marks.standing,
        "marks-walking": marks.walking,
        "marks-pairs": marks.pairs,
    }
)
_VARIED: Mapping[str, Callable[[int], Programme]] = MappingProxyType(
    {
        "situations": situations.situations,
        **{
            f"situation-{n}": partial(situations.situation, n)
            for n in range(1, situations.COUNT + 1)
        },
    }
)
"""Another seed is another way of doing the same."""


def programme_of(spec: SceneSpec, people: int, seed: int) -> Programme:
    """The programme that a scene follows.

    Raises:
        SettingsError: it is not for so many people.
    """
    fixed = _FIXED.get(spec.programme)
    programme = fixed() if fixed else _VARIED[spec.programme](seed)
    if people != len(programme.roles):
        raise SettingsError(
            f"people is {people}; the scene {spec.name} is for {len(programme.roles)}, leave it out"
        )
    return programme
