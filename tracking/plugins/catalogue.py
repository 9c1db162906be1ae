"""A catalogue: things of one kind by name, each imported when it is asked for."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Generic, TypeVar, overload

from tracking.errors import PluginError
from tracking.plugins.blame import accused
from tracking.plugins.kind import PluginKind
from tracking.plugins.loader import load
from tracking.plugins.offers import Offer, offers_of, offers_state

T = TypeVar("T")
D = TypeVar("D")


@dataclass(frozen=True, slots=True)
class CatalogueFault:
    """A plug-in that does not work, and why."""

    offer: Offer
    error: PluginError


class Catalogue(Mapping[str, T], Generic[T]):
    """What is offered of one kind.

    As a mapping it holds what works: a plug-in that cannot be loaded is left out, and stands among
    the `faults`. What is built in comes first, in its order; plug-ins follow by name. May be asked
    by any thread.

    Args:
        kind: of it. built_in: targets ("module:ATTRIBUTE") by name, in order.
        wanted: types that values may be of.
        guard: wraps what a plug-in gave, so that its mistakes name it later, too.
    """

    def __init__(
        self,
        kind: PluginKind,
        built_in: Mapping[str, str],
        wanted: Callable[[], tuple[type, ...]],
        guard: Callable[[T, Offer], T],
    ) -> None:
        self.kind = kind
        self.built_in = built_in
        self._wanted, self._guard = wanted, guard
        self._loaded: dict[Offer, T] = {}
        self._faults: dict[Offer, PluginError] = {}
        self._lock = threading.RLock()
        nothing: tuple[tuple[Offer, ...], Mapping[str, Offer]] = ((), {})
        self._as_of: tuple[object, tuple[tuple[Offer, ...], Mapping[str, Offer]]] = (None, nothing)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all that is offered; nothing is imported for them."""
        return tuple(dict.fromkeys(offer.name for offer in self.offers))

    @property
    def offers(self) -> tuple[Offer, ...]:
        """All that is offered; of one name the first counts."""
        return self._known()[0]

    def _known(self) -> tuple[tuple[Offer, ...], Mapping[str, Offer]]:
        """All offers, and those that count by name; looked up anew where others are offered."""
        state = offers_state()
        if self._as_of[0] != state:
            offers = offers_of(self.kind, self.built_in)
            firsts = {offer.name: offer for offer in reversed(offers)}
            self._as_of = (state, (offers, firsts))
        return self._as_of[1]

    @property
    def faults(self) -> tuple[CatalogueFault, ...]:
        """Plug-ins that were asked for so far and do not work."""
        offers, faults = self.offers, dict(self._faults)
        return tuple(CatalogueFault(one, faults[one]) for one in offers if one in faults)

    def offer(self, name: str) -> Offer | None:
        """What is offered under a name; None: nothing is."""
        return self._known()[1].get(name)

    def note(self, offer: Offer, error: PluginError) -> None:
        """Remember what a plug-in did wrong once it had been loaded."""
        self._faults.setdefault(offer, error)

    def load(self, offer: Offer) -> T:
        """What an offer leads to. Raises PluginError where it does not work."""
        with self._lock:
            if offer in self._loaded:
                return self._loaded[offer]
            if offer in self._faults:
                raise self._faults[offer]
            try:
                first = self.offer(offer.name)
                if first != offer:
                    raise _taken(offer, first)
                value: T = load(offer, self._wanted())
                self._loaded[offer] = value if offer.built_in else self._guard(value, offer)
            except PluginError as error:
                self._faults[offer] = error
                raise
            return self._loaded[offer]

    def load_all(self) -> None:
        """Load everything, for whoever wants to know the `faults`."""
        for offer in self.offers:
            self._loads(offer)

    def of_built_in(self) -> Iterator[T]:
        """What is built in, in order."""
        return (self.load(offer) for offer in self.offers if offer.built_in)

    def of_plugins(self) -> Iterator[tuple[Offer, T]]:
        """What plug-ins offer and works, by name."""
        for offer in self.offers:
            if not offer.built_in and self._loads(offer):
                yield offer, self._loaded[offer]

    def __getitem__(self, name: str) -> T:
        """Raises KeyError for what nobody offers, PluginError for what does not work."""
        offer = self.offer(name)
        if offer is None:
            raise KeyError(name)
        return self.load(offer)

    def __contains__(self, name: object) -> bool:
        offer = self.offer(name) if isinstance(name, str) else None
        return offer is not None and self._loads(offer)

    @overload
    def get(self, name: str, /) -> T | None: ...
    @overload
    def get(self, name: str, /, default: T | D) -> T | D: ...
    def get(self, name: str, /, default: T | D | None = None) -> T | D | None:
        """What works under a name; else the default."""
        return self[name] if name in self else default  # noqa: SIM401 - this is `get`

    def __iter__(self) -> Iterator[str]:
        return iter([offer.name for offer in self.offers if self._loads(offer)])

    def __len__(self) -> int:
        return len(list(iter(self)))

    def _loads(self, offer: Offer) -> bool:
        try:
            self.load(offer)
        except PluginError:
            return False
        return True


def _taken(offer: Offer, first: Offer | None) -> PluginError:
    if first is None:  # offered for a while, and no more
        return accused(offer, "it is no longer offered")
    return accused(offer, "its name is that of {first} already", first=first.words)
