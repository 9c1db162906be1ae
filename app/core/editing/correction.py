"""The edit that is being put together: begun, changed, planned anew at every step."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from app.core.editing import (
    EditFlow,
    EditScope,
    EditSpec,
    PlannedEdit,
    Range,
    edits,
    preview_change,
    preview_plan,
    propose_initial_box,
    propose_initial_place,
)
from app.core.editing.annotation_mode import AnnotationMode, NextBox
from app.core.editing.gap_places import gap_near, next_filled
from app.core.editing.nearness import followers_first, nearest_first
from app.core.editing.review_target import is_near
from app.core.editing.suggested_boxes import Ghost, ghosts_before, suggest_boxes
from app.core.editing.swap_candidates import find_swap_candidates
from app.core.i18n import tr
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import Place, RecordingGeometry
from app.core.tracks.selection import Selection
from tracking.editing import is_by_hand
from tracking.review import ReviewItem
from tracking.tracks import Box, TrackTable

_BOX_STEP_PX, _PLACE_STEP_M, _FAR = 1.0, 0.05, 10.0
_MOST_OTHERS = 5


class CorrectionPresenter:
    """The edit on its way in one document; nothing is changed by it.

    Attributes:
        flow: as it stands; None: no edit is on its way. planned: what it would do.
        begun_at: the frame the user was at when the edit was begun; None: no edit is on its way.
        marked: the half-open range of frames the user has set for edits over a range.
        mode: what an annotator has switched on.
        item_looked_at: gives the review item that is looked at, None for none.
    """

    def __init__(
        self,
        selection: Selection,
        geometry: RecordingGeometry,
        edit_context: Callable[[], EditContext | None],
    ) -> None:
        """`edit_context` gives what edits are planned on; None while nothing can be corrected."""
        self.flow: EditFlow | None = None
        self.planned: PlannedEdit | None = None
        self.begun_at: int | None = None
        self.marked: Range | None = None
        self.mode = AnnotationMode()
        self.item_looked_at: Callable[[], ReviewItem | None] = _no_item
        self._let_go: tuple[int, ...] = ()
        self._ghosts: tuple[Ghost, ...] = ()
        self._without_ghost: EditFlow | None = None
        self._selection = selection
        self._geometry = geometry
        self._edit_context = edit_context

    @property
    def can_place(self) -> bool:
        """Whether boxes and people can be dragged now."""
        free = self.flow is None or self.flow.places
        return free and self._edit_context() is not None

    @property
    def waits(self) -> bool:
        """Whether an edit stands ready, which another would drop."""
        return self.planned is not None and self.planned.change is not None

    @property
    def range_shown(self) -> Range | None:
        """The frames that an edit goes over where it ends somewhere, else the range set."""
        flow = self.flow
        if flow is None:
            return self.marked
        return (flow.start, flow.stop) if flow.stop is not None else None

    # beginning

    def begin(
        self,
        spec: EditSpec,
        frame: int,
        scope: EditScope | None = None,
        other: int = 0,
        box: Box | None = None,
    ) -> None:
        """Begin an edit of who is selected at a frame, perhaps with the second person already.

        box: where the edit puts theirs, in place of the one it would propose.
        """
        on = self._edit_context()
        if on is None or not (self._selection or spec in (edits.DRAW, edits.PUT)):
            return
        if self.flow is None:
            self.begun_at = frame
        everybody = self._selection.all or (0,)
        if spec is edits.MERGE:
            everybody = everybody[::-1]  # all into the one that was picked first
        flow = EditFlow.begin(
            spec,
            everybody[0],
            frame,
            self._geometry.fps,
            scope=scope,
            marked=self.marked,
            has_floor=self._geometry.view is not None,
        )
        if spec.of_several:
            flow = replace(flow, also=everybody[1:])
        if box is not None:
            flow = replace(flow, box=self._geometry.kept_inside(box))
        flow = replace(flow, others=self._others(flow, on, frame)[:_MOST_OTHERS])
        second = other or (everybody[1] if spec is edits.SWAP and len(everybody) == 2 else 0)
        self.change(self._with_other(flow, second) if second else _with_proposal(flow, on))
        self._go_to_gap(0)

    def _others(self, flow: EditFlow, on: EditContext, frame: int) -> tuple[int, ...]:
        """Who may be the second person, the likeliest first."""
        if flow.spec is edits.MERGE:
            return followers_first(on.table, flow.track, self._geometry.fps)
        return nearest_first(on.table, flow.track, frame)

    def _go_to_gap(self, step: int) -> None:
        """Put the frame looked at into one of the gaps that would be filled."""
        flow, planned = self.flow, self.planned
        change, on = planned.change if planned is not None else None, self._edit_context()
        if flow is None or flow.spec is not edits.FILL_ALL or change is None or on is None:
            return
        self.flow = replace(flow, cut=next_filled(change, flow.cut, step))
        self.planned = preview_change(self.flow, on, change)

    def begin_drawing(self, frame: int, new: bool = False) -> None:
        """W: draw a box, of who is selected or of somebody new; one that is there is replaced."""
        on = self._edit_context()
        if on is None:
            return
        if new:
            self._let_go = self._selection.all
            self._selection.choose(0)
        there = self._selection.track in on.table.of_frame(frame)["track"]
        self.begin(edits.MOVE if there else edits.DRAW, frame)
        if self.flow is not None:
            self.flow = replace(self.flow, drawing=True)

    def begin_next_box(self, frame: int) -> None:
        """A drag begins while boxes are drawn one after the other."""
        ghosts = self.ghosts_waiting(frame)
        self.begin_drawing(frame, self.next_is_new(frame))
        self._ghosts, self._without_ghost = ghosts, self.flow

    def ghosts_waiting(self, frame: int) -> tuple[Ghost, ...]:
        """Of whom the next box may be, where it lies near to where they are expected.

        Nobody's where it is said whose it is, or the selected person alone is waited for.
        """
        on, selected = self._edit_context(), self._selection.track
        if on is None or self.mode.next_box is not NextBox.AUTO:
            return ()
        ghosts = self.ghosts_before(on.table, frame, drawn_only=True)
        return ghosts if any(ghost.track != selected for ghost in ghosts) else ()

    def next_is_new(self, frame: int) -> bool:
        """Whether the next box in a frame begins a new track."""
        on = self._edit_context()
        return on is None or self.mode.begins_new(on.table, self._selection.track, frame)

    def begin_boxes(self, frame: int, boxes: Mapping[int, Box]) -> None:
        """Put boxes of several tracks in a frame."""
        on = self._edit_context()
        if on is not None and boxes:
            self.begun_at = frame if self.flow is None else self.begun_at
            flow = EditFlow.begin(edits.PUT, min(boxes), frame, self._geometry.fps)
            self.change(replace(flow, boxes=tuple(sorted(boxes.items()))))

    def ghosts_before(
        self, table: TrackTable, frame: int, *, drawn_only: bool = False
    ) -> tuple[Ghost, ...]:
        """Those of everybody who was there just before, may be in the picture and is waited for.

        drawn_only: of those who are drawn by hand.
        """
        found = ghosts_before(table, frame, self._geometry.fps, drawn_only=drawn_only)
        size = self._geometry.size
        return tuple(
            ghost for ghost in found if self.mode.is_waited_for(ghost) and ghost.is_inside(size)
        )

    @property
    def finishes_at_once(self) -> bool:
        """Whether the edit on its way is to be done without waiting for Enter."""
        return self.flow is not None and self.waits and self.mode.does_at_once(self.flow)

    # the second person

    def pick(self, track: int) -> None:
        """A person was clicked: select them, or give them to the edit that waits for one."""
        if self.flow is None:
            self._selection.choose(track)
        elif self.flow.needs_other and track and track != self.flow.track:
            self.change(self._with_other(self.flow, track))

    def add(self, track: int) -> None:
        """A person was clicked with Shift: select them too, or no longer."""
        if self.flow is None:
            self._selection.add(track)
        else:
            self.pick(track)

    def pick_typed(self, track: int) -> None:
        """An id was typed for the other person of the edit; one that cannot be is told."""
        flow, on = self.flow, self._edit_context()
        if flow is None or on is None or not flow.takes_other:
            return
        if track == flow.track:
            said = tr("{track} is the selected person: type another id", track=track)
            self.change(flow, said)
        elif track not in on.table and flow.spec is not edits.REASSIGN:
            self.change(flow, tr("There is no track {track}", track=track))
        else:
            self.change(self._with_other(flow, track))

    def consider(self, track: int) -> None:
        """An id was typed so far: show the edit with them where there is such a track."""
        flow, on = self.flow, self._edit_context()
        if flow is None or on is None or not flow.takes_other or track == flow.other:
            return
        if track in on.table and track != flow.track:
            self.change(self._with_other(flow, track))
        elif flow.other:
            self.change(replace(flow, other=0, cuts=()))

    def pick_next(self, here: list[int], step: int) -> None:
        """Tab: the next of the people who are here; for the second of an edit the nearest first."""
        flow = self.flow
        if flow is None:
            self._selection.choose(self._selection.cycle(here, step))
        elif flow.takes_other:
            # Who is here beside the person is somebody else: no merge makes one of the two.
            more = () if flow.spec is edits.MERGE and flow.others else here
            choices = [*flow.others, *(one for one in more if one not in flow.others)]
            choices = [one for one in choices if one != flow.track]
            if choices:
                now = choices.index(flow.other) if flow.other in choices else min(-step, 0)
                self.change(self._with_other(flow, choices[(now + step) % len(choices)]))

    def _with_other(self, flow: EditFlow, other: int) -> EditFlow:
        """The edit with its second person; for a swap with the frames where they changed over."""
        on = self._edit_context()
        if flow.spec is not edits.SWAP or on is None or other == flow.track:
            return flow.with_other(other)
        # A frame that was proposed for somebody else says nothing of where the user looks.
        near = flow.cut if not flow.proposed or self.begun_at is None else self.begun_at
        two, fps = {flow.track, other}, self._geometry.fps
        one = self.item_looked_at()
        if one is None or not two.issuperset(one.tracks) or not is_near(one, near, fps):
            return flow.with_other(other, find_swap_candidates(on, flow.track, other, near))
        cuts = find_swap_candidates(on, flow.track, other, one.frame, (one.start, one.end))
        return flow.with_other(other, cuts)

    # changing

    def change(self, flow: EditFlow, problem: str = "") -> None:
        """Put another state of the edit in place of the one there is; `problem` is told with it."""
        on = self._edit_context()
        if on is not None:
            self.flow = flow
            self.planned = preview_plan(flow, on, problem)

    def next_proposal(self, step: int) -> None:
        """Up or Down: another of the people, or of the frames, that were found."""
        flow = self.flow
        if flow is None:
            return
        if flow.needs_other:
            self.pick_next([], step)
        elif flow.cuts:
            self.change(flow.at_cut(flow.cut_number + step))
        else:
            self._go_to_gap(step)

    def put_box(self, box: Box, frame: int) -> None:
        """The selected person's box is drawn or dragged; the edit begins where it has not yet."""
        if self.flow is None or not self.flow.places or self.flow.spec is edits.FLOOR:
            self.begin(edits.MOVE, frame)
        if self.flow is not None:
            flow = replace(self.flow, box=self._geometry.kept_inside(box))
            self.change(self._with_track_found(flow) if self._ghosts and flow.drawing else flow)

    def _with_track_found(self, flow: EditFlow) -> EditFlow:
        """The drawn box, given to the track expected near to it, else to the one it began with."""
        track = suggest_boxes([flow.box], self._ghosts)[0].track if flow.box is not None else 0
        if track:
            return replace(flow, spec=edits.DRAW, track=track, scope=EditScope.JOINED)
        return (
            replace(self._without_ghost, box=flow.box, drawing=True)
            if self._without_ghost
            else flow
        )

    def put_place(self, place: Place, frame: int) -> None:
        """The selected person is dragged over the floor."""
        if self.flow is None or self.flow.spec is not edits.FLOOR:
            self.begin(edits.FLOOR, frame)
        if self.flow is not None:
            self.change(replace(self.flow, place=place))

    def nudge(self, right: int, down: int, *, far: bool = False, resize: bool = False) -> None:
        """An arrow key: move the box or the person a little or far, or make the box larger."""
        flow, steps = self.flow, _FAR if far else 1.0
        if flow is None or not flow.places:
            return
        if flow.spec is edits.FLOOR and flow.place is not None:
            step = steps * _PLACE_STEP_M
            place = flow.place[0] + right * step, flow.place[1] - down * step
            self.change(replace(flow, place=place))
        elif flow.box is not None:
            left, top, width, height = flow.box
            across, along = right * steps * _BOX_STEP_PX, down * steps * _BOX_STEP_PX
            moved = (left + across, top + along, width, height)
            grown = (left, top, width + across, height + along)
            self.change(replace(flow, box=self._geometry.kept_inside(grown if resize else moved)))

    # the range

    def mark(self, start: int | None = None, stop: int | None = None) -> None:
        """[ and ]: set where the range starts or stops; the other end stays on its side."""
        first, last = self.marked or (None, None)
        if start is not None:
            end = last if last is not None and last > start else self._geometry.frame_count
            self.marked = start, end
        elif stop is not None:
            self.marked = (first if first is not None and first < stop else 0), stop
        if self.flow is not None and self.marked is not None and not self.flow.places:
            self.change(self.flow.with_range(*self.marked))

    def unmark(self) -> None:
        """No range any more."""
        self.marked = None

    # the end

    def leave(self) -> None:
        """Leave the edit; everything is as before, and selected who was let go for it."""
        self.flow = self.planned = self.begun_at = None
        for track in reversed(self._let_go if not self._selection else ()):
            self._selection.add(track)
        self._let_go = self._ghosts = ()

    def finish(self) -> None:
        """The edit was done: who was let go for it stays let go."""
        self.mode.next_box = NextBox.AUTO
        self._let_go = ()
        self.leave()


def _no_item() -> ReviewItem | None:
    """No review is going on."""
    return None


def _with_proposal(flow: EditFlow, on: EditContext) -> EditFlow:
    """The edit with the box, the place or the gap it begins with."""
    if flow.spec is edits.FILL:
        gap = gap_near(on.table, flow.track, flow.cut)
        return flow if gap is None else replace(flow, cut=gap)
    if not flow.places:
        return flow
    box = flow.box or propose_initial_box(flow, on)
    place = propose_initial_place(flow, on)
    joined = flow.spec is edits.DRAW and is_by_hand(on.table, flow.track)
    return replace(flow, box=box, place=place, scope=EditScope.JOINED if joined else flow.scope)
