"""An edit on its way: who, with whom, from which frame, how far; then Enter or Esc."""

from __future__ import annotations

from dataclasses import dataclass, replace

from app.core.editing.edit_options import EditScope, Fill, LongestGap, Option, Way
from app.core.editing.edit_spec import EditSpec
from app.core.tracks.recording_geometry import Place
from tracking.editing import SwapFrame
from tracking.tracks import Box

Range = tuple[int, int]
"""A half-open range of frames."""


@dataclass(frozen=True, slots=True)
class EditFlow:
    """An edit that is being put together; every step makes a new one.

    Attributes:
        spec: what. track: the selected person; 0: one who is still to be drawn.
        cut: the first frame that changes. end: half-open, used by `Reach.RANGE` alone.
        also: others who are selected too. other: the second person, or the other id; 0: not yet.
        scope: how far. way, fill: how. longest: of the gaps that are filled.
        proposed: the cut is one of `cuts`, found from how the two walked and looked.
        cuts: where the two may have changed over, the likeliest first.
        others: ids of people who may be meant, the nearest first.
        marked: the range the user has set, if any.
        has_floor: there are metres, so that a way along the floor can be chosen.
        box: drawn, moved or proposed, px of the left picture. place: the same on the floor, m.
        boxes: of several tracks, put together.
        drawing: a box may be drawn with the mouse in place of the proposed one.
        asked_at: the frame in which it was begun; -1: not known.
    """

    spec: EditSpec
    track: int
    cut: int
    end: int
    also: tuple[int, ...] = ()
    other: int = 0
    scope: EditScope = EditScope.ON
    way: Way = Way.FLOOR
    fill: Fill = Fill.LEAVE
    longest: LongestGap = LongestGap.SECOND
    proposed: bool = False
    cuts: tuple[SwapFrame, ...] = ()
    others: tuple[int, ...] = ()
    marked: Range | None = None
    has_floor: bool = False
    box: Box | None = None
    place: Place | None = None
    boxes: tuple[tuple[int, Box], ...] = ()
    drawing: bool = False
    asked_at: int = -1

    @classmethod
    def begin(
        cls,
        spec: EditSpec,
        track: int,
        frame: int,
        fps: float,
        *,
        scope: EditScope | None = None,
        marked: Range | None = None,
        has_floor: bool = False,
    ) -> EditFlow:
        """Start an edit of a track at a frame; a range nobody has set is a second long at first.

        What is usually of one frame goes over the range that is set around that frame.
        """
        ways = spec.ways_with(has_floor=has_floor)
        return cls(
            spec,
            track,
            frame,
            frame + max(1, round(fps)),
            scope=spec.scopes[0],
            way=ways[0] if ways else Way.FLOOR,
            marked=marked,
            has_floor=has_floor,
            asked_at=frame,
        ).with_scope(scope or _usual_scope(spec, frame, marked))

    @property
    def everybody(self) -> tuple[int, ...]:
        """All whom the edit is about, the selected person first."""
        return (self.track, *self.also)

    @property
    def takes_other(self) -> bool:
        """Whether the edit is one of two people and asks who the second is."""
        return self.spec.of_two and not (self.spec.of_several and self.also)

    @property
    def needs_other(self) -> bool:
        """Whether the second person is still to be picked."""
        return self.takes_other and not self.other

    @property
    def places(self) -> bool:
        """Whether a box or a place is put, which the arrow keys move."""
        return self.spec.places

    @property
    def has_cut(self) -> bool:
        """Whether the cut can be moved."""
        return not self.places and self.scope not in (EditScope.WHOLE,)

    @property
    def has_end(self) -> bool:
        """Whether the end can be moved."""
        return self.scope is EditScope.RANGE

    @property
    def leads(self) -> bool:
        """Whether the playhead goes to the cut when that is put elsewhere.

        Marking what was looked at is judged by nothing at its cut: it leaves the playhead.
        """
        return self.has_cut if self.spec.leads is None else self.spec.leads

    @property
    def start(self) -> int:
        """The first frame the edit may touch."""
        return 0 if self.scope is EditScope.WHOLE else self.cut

    @property
    def stop(self) -> int | None:
        """The frame the edit ends before; None: it goes on to the end."""
        return {EditScope.RANGE: self.end, EditScope.FRAME: self.cut + 1}.get(self.scope)

    # steps

    def with_other(self, other: int, cuts: tuple[SwapFrame, ...] = ()) -> EditFlow:
        """The edit with its second person, and for a swap the frames where they changed over."""
        if other == self.track:
            return self
        chosen = replace(self, other=other, cuts=cuts, proposed=False)
        return chosen.at_cut(0) if cuts and self.has_cut else chosen

    def at_cut(self, number: int) -> EditFlow:
        """The edit at one of the frames that were found; beyond the last comes the first."""
        if not self.cuts:
            return self
        frame = self.cuts[number % len(self.cuts)].frame
        return replace(self, cut=frame, end=frame + self.end - self.cut, proposed=True)

    @property
    def cut_number(self) -> int:
        """Which of the frames that were found is the cut; -1: none of them."""
        return next((n for n, one in enumerate(self.cuts) if one.frame == self.cut), -1)

    def moved(self, frames: int, frame_count: int) -> EditFlow:
        """The edit with its cut some frames on or back; a range moves along."""
        cut = min(max(0, self.cut + frames), frame_count - 1)
        return replace(self, cut=cut, end=self.end + cut - self.cut, proposed=False)

    def with_end_moved(self, frames: int, frame_count: int) -> EditFlow:
        """The edit with the end of its range some frames on or back."""
        return replace(self, end=min(max(self.cut + 1, self.end + frames), frame_count))

    def with_range(self, start: int, end: int) -> EditFlow:
        """The edit over a range; where it can go that far, it does from now on."""
        ranged = replace(self, marked=(start, end))
        return ranged.with_scope(EditScope.RANGE) if EditScope.RANGE in self.spec.scopes else ranged

    def with_scope(self, scope: EditScope) -> EditFlow:
        """The edit going as far; a range is the one the user has set, where there is one."""
        if scope not in self.spec.scopes:
            return self
        if scope is EditScope.RANGE and self.marked is not None:
            start, end = self.marked
            return replace(self, scope=scope, cut=start, end=end, proposed=False)
        return replace(self, scope=scope)

    # choices

    @property
    def choices(self) -> tuple[tuple[Option, ...], tuple[Option, ...]]:
        """What the first and the second key choose between; one or none: nothing to choose."""
        if self.places and not self.track:
            return (EditScope.FRAME,), ()
        return self.spec.choices(has_floor=self.has_floor)

    def chosen(self, row: int) -> int:
        """Which of the choices of a row is in force."""
        options = self.choices[row]
        now: tuple[Option, ...] = (self.scope, self.way, self.fill, self.longest)
        return next((n for n, option in enumerate(options) if option in now), 0)

    def with_choice(self, row: int, number: int) -> EditFlow:
        """The edit with another of a row's choices; beyond the last one comes the first again."""
        options = self.choices[row]
        if not options:
            return self
        option = options[number % len(options)]
        if isinstance(option, EditScope):
            return self.with_scope(option)
        if isinstance(option, LongestGap):
            return replace(self, longest=option)
        return replace(self, way=option) if isinstance(option, Way) else replace(self, fill=option)


def _usual_scope(spec: EditSpec, frame: int, marked: Range | None) -> EditScope:
    """How far an edit goes of which nobody says it."""
    inside = marked is not None and marked[0] <= frame < marked[1]
    ranged = inside and spec.scopes[0] is EditScope.FRAME and EditScope.RANGE in spec.scopes
    return EditScope.RANGE if ranged else spec.scopes[0]
