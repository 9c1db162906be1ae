"""The list of parts that are worth labelling, walked from one to the next."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from app.core.scenes.labels import SuggestedPart
from tracking.tracks import PartKey, PartLabels

_LISTED = 200


class SuggestionQueue:
    """Suggestions, those that are labelled by now left out; and which of them is looked at."""

    def __init__(self) -> None:
        self._all: tuple[SuggestedPart, ...] = ()
        self._labels = PartLabels()
        self._open: tuple[SuggestedPart, ...] = ()
        self._current: SuggestedPart | None = None
        self._place = -1

    @property
    def open(self) -> tuple[SuggestedPart, ...]:
        """What is left, the best first."""
        return self._open

    @property
    def current(self) -> SuggestedPart | None:
        """What is looked at."""
        return self._current

    @property
    def place(self) -> int:
        """The number of what is looked at among those left; -1: none of them."""
        return self._open.index(self._current) if self._current in self._open else -1

    def take(self, suggestions: Sequence[SuggestedPart], labels: PartLabels) -> None:
        """Walk other suggestions from now on."""
        self._all, self._labels = tuple(suggestions), labels
        self._current, self._place = None, -1
        self._sift()

    def replace_each(
        self, anew: Callable[[Sequence[SuggestedPart]], Sequence[SuggestedPart]]
    ) -> None:
        """The same suggestions, told otherwise; who is looked at stays."""
        place = self.place
        self._all = tuple(anew(self._all))
        self._sift()
        self._current = self._open[place] if place >= 0 else None

    def take_labels(self, labels: PartLabels) -> None:
        """Leave out what is labelled by now; what was taken back is there again."""
        if labels is not self._labels:
            self._labels = labels
            self._sift()

    def _sift(self) -> None:
        left = (one for one in self._all if one.key not in self._labels)
        self._open = tuple(one for one, _ in zip(left, range(_LISTED), strict=False))

    def walk(self, step: int) -> SuggestedPart | None:
        """Go on to the next (1) or previous (-1) one that is left; None where none is.

        What was just labelled is left out by then: the next one has taken its place.
        """
        if not self._open:
            self._current = None
            return None
        here = self.place if self.place >= 0 else self._place - (step > 0)
        at = here + step
        self._place = min(max(at, 0), len(self._open) - 1)
        self._current = self._open[self._place]
        return self._current

    def choose(self, number: int) -> SuggestedPart | None:
        """One was clicked."""
        if 0 <= number < len(self._open):
            self._place, self._current = number, self._open[number]
        return self._current

    def return_to(self, key: PartKey) -> SuggestedPart | None:
        """What was said of a part was taken back: it is looked at again where it is listed."""
        numbers = [number for number, one in enumerate(self._open) if one.key == key]
        self._current = None
        return self.choose(numbers[0]) if numbers else None

    def leave(self) -> None:
        """Nothing suggested is looked at any more."""
        self._current = None
