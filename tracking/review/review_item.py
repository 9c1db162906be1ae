"""One place in the footage where tracks are likely wrong."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.translation import Message

ReviewItemKey = tuple[str, tuple[int, ...], int]
"""Kind, tracks and frame: what a verdict is about."""


@dataclass(frozen=True, slots=True)
class ReviewItem:
    """A place to look at, and why.

    Attributes:
        kind: of the strongest reason, e.g. "crossing"; "margin" or "lost".
        tracks: the tracks it is about, ascending.
        frame: where it happened.
        start, end: half-open stretch to watch, from just before to just after.
        likelihood: 0 to 1, how likely the tracks are wrong here.
        cost: rows of tracks that would be wrong until one of the tracks ends or they meet again.
        text: why it is there, to be translated where it is shown; the strongest reason.
        fix: what would put it right: "swap", "split", "merge", "delete" or "look".
        others: the further reasons that fell on the same people at the same time.
    """

    kind: str
    tracks: tuple[int, ...]
    frame: int
    start: int
    end: int
    likelihood: float
    cost: float
    text: Message
    fix: str
    others: tuple[Message, ...] = ()

    @property
    def key(self) -> ReviewItemKey:
        """What a verdict on it is kept under."""
        return self.kind, self.tracks, self.frame

    @property
    def worth(self) -> float:
        """Rows that looking at it is expected to put right: likelihood times cost."""
        return self.likelihood * self.cost
