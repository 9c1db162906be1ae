"""What is offered by name: from a table of our own, and from the entry points of packages."""

from __future__ import annotations

import importlib.metadata
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import count
from typing import Final

from tracking.plugins.kind import PluginKind
from tracking.translation import Message, msg

WITHOUT: Final = "TRACKWRIGHT_PLUGINS"
"""A variable of the environment; "off": only what is built in is offered."""
OWN: Final = "trackwright"
"""The distribution of what is built in."""


@dataclass(frozen=True, slots=True)
class Offer:
    """One thing that can be loaded.

    Attributes:
        kind: of it. name: unique within its kind.
        target: where it stands, as "module:ATTRIBUTE".
        built_in: it comes with this program.
        serial: tells offers of one target apart: those handed over in this process, and packages
            that were put in another's place.
        value: the thing itself, where it was handed over.
    """

    kind: PluginKind
    name: str
    target: str
    built_in: bool = False
    serial: int = 0
    entry_point: importlib.metadata.EntryPoint | None = field(
        default=None, repr=False, compare=False
    )
    value: object = field(default=None, repr=False, compare=False)

    @property
    def module(self) -> str:
        """The module of the target."""
        return self.target.partition(":")[0]

    @property
    def package(self) -> str:
        """The distribution it comes from."""
        if self.built_in:
            return OWN
        found = self.entry_point.dist if self.entry_point is not None else None
        return found.name if found is not None else self.module.partition(".")[0]

    @property
    def version(self) -> str:
        """The version of that distribution; "" where it is not known."""
        found = self.entry_point.dist if self.entry_point is not None else None
        return found.version if found is not None else ""

    @property
    def words(self) -> Message:
        """For messages: what it is and where it comes from."""
        thing = msg(self.kind.named, name=self.name)
        if self.built_in:
            return thing
        return msg(
            "{thing} (plug-in {package})",
            thing=thing,
            package=" ".join(filter(None, (self.package, self.version))),
        )


_for_a_while: list[Offer] = []
_serials = count(1)
_state = _looks = 0
"""The first changes with what is offered, the second counts from which look packages are known."""


@contextmanager
def offered_for_a_while(kind: PluginKind, name: str, value: object, module: str) -> Iterator[Offer]:
    """Offer something in this process without installing it, as tests do.

    Catalogues that were asked before take it up; when the block ends, it is gone again.
    """
    global _state
    offer = Offer(kind, name, f"{module}:{name}", serial=next(_serials), value=value)
    _for_a_while.append(offer)
    _state += 1
    try:
        yield offer
    finally:
        _for_a_while.remove(offer)
        _state += 1


def offers_state() -> tuple[int, bool]:
    """Is another one whenever something else is offered than before."""
    return _state, os.environ.get(WITHOUT, "").lower() not in ("off", "0", "no")


def offers_of(kind: PluginKind, built_in: Mapping[str, str]) -> tuple[Offer, ...]:
    """Everything of a kind: what is built in, in its order, then plug-ins by name.

    Names may be given twice: whoever loads takes the first.

    Args:
        built_in: targets by name.
    """
    own = tuple(Offer(kind, name, target, built_in=True) for name, target in built_in.items())
    _, with_plugins = offers_state()
    others = [
        Offer(kind, point.name, point.value, serial=_looks, entry_point=point)
        for point in (_installed() if with_plugins else ())
        if point.group == kind.group and built_in.get(point.name) != point.value
    ]
    given = [offer for offer in _for_a_while if offer.kind is kind]
    return (*own, *sorted([*others, *given], key=lambda offer: (offer.name, offer.target)))


@lru_cache(1)
def _installed() -> tuple[importlib.metadata.EntryPoint, ...]:
    """The entry points of all kinds, read once: each look goes through every package."""
    groups = [kind.group for kind in PluginKind]
    points = importlib.metadata.entry_points()
    return tuple(point for group in groups for point in points.select(group=group))


def look_again() -> None:
    """Read the entry points anew the next time: packages were installed meanwhile."""
    global _state, _looks
    _installed.cache_clear()
    _state += 1
    _looks -= 1
