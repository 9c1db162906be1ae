"""Who is selected: one selection for all views."""

from __future__ import annotations

from collections.abc import Iterable, Sequence


class Selection:
    """The selected track, 0 for nobody, and others that were added to it.

    Attributes:
        track: the one that was picked last. also: the others, in the order they were picked.
    """

    def __init__(self) -> None:
        self.track = 0
        self.also: tuple[int, ...] = ()

    def __bool__(self) -> bool:
        """Whether anybody is selected."""
        return self.track > 0

    @property
    def all(self) -> tuple[int, ...]:
        """Everybody who is selected, who was picked last first."""
        return (self.track, *self.also) if self.track else ()

    def choose(self, track: int) -> bool:
        """Select a track alone, or nobody (0); True where that is another than before."""
        changed = track != self.track or bool(self.also)
        self.track, self.also = track, ()
        return changed

    def choose_all(self, tracks: Sequence[int]) -> None:
        """Select these together, as if they had been picked one after the other."""
        self.track, self.also = (tracks[-1], tuple(tracks[-2::-1])) if tracks else (0, ())

    def add(self, track: int) -> None:
        """Add a track to the selected ones, or take it out where it is among them."""
        if not track:
            return
        if track in self.all:
            rest = tuple(one for one in self.all if one != track)
            self.track, self.also = (rest[0], rest[1:]) if rest else (0, ())
        else:
            self.track, self.also = track, self.all

    def keep(self, known: Iterable[int]) -> None:
        """Let go whoever is not among the known tracks any more."""
        rest = tuple(one for one in self.all if one in set(known))
        self.track, self.also = (rest[0], rest[1:]) if rest else (0, ())

    def cycle(self, tracks: Sequence[int], step: int = 1, skip: int = 0) -> int:
        """The next (1) or previous (-1) of the tracks after the selected one, wrapping around.

        `skip` is never given: the person an edit already holds. 0 where nobody is left.
        """
        choices = sorted(set(tracks) - {skip})
        if not choices:
            return 0
        if self.track in choices:
            return choices[(choices.index(self.track) + step) % len(choices)]
        later = [track for track in choices if track > self.track]
        if step > 0:
            return later[0] if later else choices[0]
        earlier = [track for track in choices if track < self.track]
        return earlier[-1] if earlier else choices[-1]
