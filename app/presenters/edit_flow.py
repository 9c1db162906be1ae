"""An edit on its way: who, with whom, from which frame, how far; then Enter or Esc."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum

from tracking.editing import (
    Change,
    Keep,
    plan_delete,
    plan_merge,
    plan_split,
    plan_swap,
    propose_swap_frame,
)
from tracking.errors import EditError
from tracking.tracks import Labels, TrackTable


class EditKind(Enum):
    """What is to be done."""

    SWAP = "swap"
    SPLIT = "split"
    MERGE = "merge"
    DELETE = "delete"


class Scope(Enum):
    """How far an edit goes."""

    ON = "from here on"
    RANGE = "this range"
    FRAME = "this frame"
    WHOLE = "the whole track"


SCOPES: dict[EditKind, tuple[Scope, ...]] = {
    EditKind.SWAP: (Scope.ON, Scope.RANGE, Scope.FRAME),
    EditKind.SPLIT: (Scope.ON,),
    EditKind.MERGE: (Scope.WHOLE,),
    EditKind.DELETE: (Scope.ON, Scope.RANGE, Scope.FRAME),
}
KEEPS: tuple[Keep, ...] = ("first", "second")
"""Whose rows a merge keeps where both stand: the selected person's, or the other's."""

_NEEDS_OTHER = (EditKind.SWAP, EditKind.MERGE)


@dataclass(frozen=True, slots=True)
class EditFlow:
    """An edit that is being put together; every step makes a new one.

    Attributes:
        kind: what. track: the selected person. other: the second one, 0 until picked.
        cut: the first frame that changes. end: half-open, used by `Scope.RANGE` alone.
        scope: how far. keep: of a merge, whose rows stay where both stand.
        proposed: the cut was found from where the two came closest.
    """

    kind: EditKind
    track: int
    cut: int
    end: int
    other: int = 0
    scope: Scope = Scope.ON
    keep: Keep = "first"
    proposed: bool = False

    @classmethod
    def begin(cls, kind: EditKind, track: int, frame: int, fps: float) -> EditFlow:
        """Start an edit of a track at a frame; a range is a second long at first."""
        return cls(kind, track, frame, frame + max(1, round(fps)), scope=SCOPES[kind][0])

    @property
    def needs_other(self) -> bool:
        """Whether the second person is still to be picked."""
        return self.takes_other and not self.other

    @property
    def has_cut(self) -> bool:
        """Whether the cut can be moved."""
        return self.kind is not EditKind.MERGE

    def with_other(self, other: int, table: TrackTable) -> EditFlow:
        """The edit with its second person, and for a swap the frame where they crossed."""
        if other == self.track:
            return self
        chosen = replace(self, other=other)
        if self.kind is not EditKind.SWAP:
            return chosen
        try:
            frame = propose_swap_frame(table, self.track, other, near=self.cut)
        except EditError:
            return chosen  # the plan says what is wrong
        return replace(chosen, cut=frame, end=frame + self.end - self.cut, proposed=True)

    def moved(self, frames: int, frame_count: int) -> EditFlow:
        """The edit with its cut some frames on or back; a range moves along."""
        cut = min(max(0, self.cut + frames), frame_count - 1)
        return replace(self, cut=cut, end=self.end + cut - self.cut, proposed=False)

    def with_end_moved(self, frames: int, frame_count: int) -> EditFlow:
        """The edit with the end of its range some frames on or back."""
        return replace(self, end=min(max(self.cut + 1, self.end + frames), frame_count))

    @property
    def choice(self) -> int:
        """Which of its choices is in force: of a merge whom to keep, else how far it goes."""
        if self.kind is EditKind.MERGE:
            return KEEPS.index(self.keep)
        return SCOPES[self.kind].index(self.scope)

    def with_choice(self, number: int) -> EditFlow:
        """The edit with another of its choices; beyond the last one comes the first again."""
        if self.kind is EditKind.MERGE:
            return replace(self, keep=KEEPS[number % len(KEEPS)])
        scopes = SCOPES[self.kind]
        return replace(self, scope=scopes[number % len(scopes)])

    @property
    def takes_other(self) -> bool:
        """Whether the edit is one of two people."""
        return self.kind in _NEEDS_OTHER

    @property
    def stop(self) -> int | None:
        """The frame the edit ends before; None: it goes on to the end."""
        return {Scope.RANGE: self.end, Scope.FRAME: self.cut + 1}.get(self.scope)

    def plan(self, table: TrackTable, labels: Labels) -> Change:
        """The change that Enter applies.

        Raises:
            EditError: the edit does not apply to the tracks as they are.
        """
        if self.needs_other:
            raise EditError(f"{self.kind.value}: the other person is not picked yet, click on them")
        if self.kind is EditKind.SWAP:
            return plan_swap(table, self.track, self.other, self.cut, self.stop)
        if self.kind is EditKind.SPLIT:
            return plan_split(table, self.track, self.cut)
        if self.kind is EditKind.MERGE:
            return plan_merge(table, self.track, self.other, self.keep, labels)
        return plan_delete(table, self.track, self.cut, self.stop)
