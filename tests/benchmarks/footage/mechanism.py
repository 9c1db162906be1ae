"""A mechanism of a tracker that can be left out: by settings, or by what stands in its place."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tests.benchmarks.footage import stand_ins

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
        finishing: it is a part of finishing runs: one run is finished with it and without.
        seeing: it is a part of finding people, before the tracker.
    """

    name: str
    what: str
    settings: Values = ()
    replaced: Values = ()
    finishing: bool = False
    seeing: bool = False


def left_out(name: str, what: str, *replaced: tuple[str, Any]) -> Mechanism:
    """A mechanism of a tracker's steps; a stand-in is named by its function in `stand_ins`."""
    return Mechanism(name, what, replaced=_with_stand_ins(replaced))


def seeing(name: str, what: str, *replaced: tuple[str, Any]) -> Mechanism:
    """A mechanism of finding people."""
    return Mechanism(name, what, replaced=_with_stand_ins(replaced), seeing=True)


def finishing(name: str, what: str, *replaced: tuple[str, Any]) -> Mechanism:
    """A mechanism of finishing runs."""
    return Mechanism(name, what, replaced=_with_stand_ins(replaced), finishing=True)


def set_to(name: str, what: str, **settings: Any) -> Mechanism:
    """A mechanism that settings turn off; `__` stands for the dot of a nested one."""
    values = {key.replace("__", "."): value for key, value in settings.items()}
    return Mechanism(name, what, settings=tuple(values.items()))


def _with_stand_ins(replaced: tuple[tuple[str, Any], ...]) -> Values:
    here = stand_ins.__name__
    return tuple(
        (f"tracking.{name}", f"{here}.{value}" if isinstance(value, str) else value)
        for name, value in replaced
    )
