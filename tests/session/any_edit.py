"""Any edit of a small session, drawn at random; many that are drawn are refused."""

from __future__ import annotations

from collections.abc import Callable

from hypothesis import strategies as st

from tracking.editing import (
    Change,
    plan_add_keyframe,
    plan_delete,
    plan_delete_keyframe,
    plan_delete_tracks,
    plan_draw_box,
    plan_fill_gap,
    plan_interpolate,
    plan_label_part,
    plan_mark_occluded,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_move_box,
    plan_new_track,
    plan_reassign,
    plan_rename,
    plan_set_notes,
    plan_split,
    plan_swap,
    plan_thin,
    plan_unmark_reviewed,
    plan_verdict,
)
from tracking.session import Session
from tracking.tracks import PartLabel, Verdict

TRACKS = st.integers(1, 5)
FRAMES = st.integers(0, 14)
BOXES = st.tuples(*[st.sampled_from((1.0, 2.5, 40.0))] * 4)
DECISIONS = st.sampled_from(("right", "fixed", "dismissed"))
SAID_OF_PARTS = st.sampled_from((True, False, None))
Plan = Callable[[], Change]


def row_plan(draw: st.DrawFn, session: Session) -> Plan:
    """A planner of rows with what it is asked."""
    table, labels = session.tracks, session.labels
    a, b, start = draw(TRACKS), draw(TRACKS), draw(FRAMES)
    end, box = draw(st.none() | FRAMES), draw(BOXES)
    stop = 15 if end is None else end
    plans: tuple[Plan, ...] = (
        lambda: plan_swap(table, a, b, start, end),
        lambda: plan_split(table, a, start),
        lambda: plan_merge_tracks(table, a, [b], labels=labels, fill=start > 7),
        lambda: plan_merge_tracks(table, a, (b, b % 5 + 1), "surer", labels),
        lambda: plan_reassign(table, a, b, start, end),
        lambda: plan_delete(table, a, start, end),
        lambda: plan_delete_tracks(table, (a, b), start, end),
        lambda: plan_new_track(table, start, box),
        lambda: plan_draw_box(table, a, start, box, join=end is None),
        lambda: plan_move_box(table, a, start, box),
        lambda: plan_add_keyframe(table, a, start),
        lambda: plan_delete_keyframe(table, a, start),
        lambda: plan_interpolate(table, a, start, stop),
        lambda: plan_fill_gap(table, a, start),
        lambda: plan_thin(table, a, start, stop, 50.0),
        lambda: plan_mark_occluded(table, (a, b), start, end, occluded=start > 7),
    )
    return draw(st.sampled_from(plans))


def label_plan(draw: st.DrawFn, session: Session) -> Plan:
    """A planner of labels with what it is asked."""
    table, labels = session.tracks, session.labels
    a, b, start, end = draw(TRACKS), draw(TRACKS), draw(FRAMES), draw(FRAMES)
    part = PartLabel(start, a, b % 3, draw(BOXES), draw(SAID_OF_PARTS), "person")
    verdict = Verdict("crossing", (a, b), start, draw(DECISIONS))
    plans: tuple[Plan, ...] = (
        lambda: plan_rename(table, labels, a, f"person {start}"),
        lambda: plan_set_notes(table, labels, a, f"seen in {start}"),
        lambda: plan_mark_reviewed(labels, (a, b), start, end),
        lambda: plan_unmark_reviewed(labels, (a, b), start, end),
        lambda: plan_verdict(labels, verdict),
        lambda: plan_label_part(labels, (part,)),
    )
    return draw(st.sampled_from(plans))
