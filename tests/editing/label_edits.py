"""Any edit of labels, drawn at random."""

from __future__ import annotations

from collections.abc import Callable

from hypothesis import strategies as st

from tracking.editing import (
    Change,
    plan_label_part,
    plan_lines,
    plan_mark_reviewed,
    plan_occluders,
    plan_regions,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
    plan_unlabel_part,
    plan_unmark_reviewed,
    plan_verdict,
)
from tracking.tracks import (
    CountingLine,
    Labels,
    Occluder,
    PartLabel,
    Region,
    TrackTable,
    Verdict,
)

TRACKS = st.integers(1, 5)
FRAMES = st.integers(0, 12)
NAMES = st.sampled_from(("door", "hall", "赤い"))
PLACES = st.tuples(*[st.floats(-1e3, 1e3)] * 2)
LINES = st.builds(CountingLine, NAMES, PLACES, PLACES)
OCCLUDERS = st.builds(Occluder, NAMES, st.tuples(PLACES, PLACES, PLACES))
REGIONS = st.builds(Region, NAMES, st.tuples(PLACES, PLACES, PLACES))
VERDICTS = st.builds(
    Verdict,
    st.sampled_from(("crossing", "jump")),
    st.tuples(TRACKS, TRACKS),
    FRAMES,
    st.sampled_from(("right", "fixed", "dismissed")),
)
PARTS = st.builds(
    PartLabel,
    FRAMES,
    TRACKS,
    st.integers(0, 2),
    st.tuples(*[st.floats(0.5, 1e3)] * 4),
    st.sampled_from((True, False, None)),
    st.sampled_from(("person", "tracker", "truth")),
)


def label_plans(draw: st.DrawFn, table: TrackTable, labels: Labels) -> list[Callable[[], Change]]:
    """Planners that may refuse what is drawn."""
    reviewed = st.lists(st.integers(0, 3), max_size=3)
    plans = [
        lambda: plan_rename(table, labels, draw(TRACKS), draw(NAMES)),
        lambda: plan_set_attribute(
            table, labels, draw(TRACKS), draw(NAMES), draw(st.none() | NAMES)
        ),
        lambda: plan_set_notes(table, labels, draw(TRACKS), draw(NAMES)),
        lambda: plan_mark_reviewed(labels, draw(reviewed), draw(FRAMES), draw(FRAMES)),
        lambda: plan_unmark_reviewed(labels, draw(reviewed), draw(FRAMES), draw(FRAMES)),
        lambda: plan_occluders(labels, draw(st.lists(OCCLUDERS, max_size=2))),
        lambda: plan_lines(labels, draw(st.lists(LINES, max_size=2))),
        lambda: plan_regions(labels, draw(st.lists(REGIONS, max_size=2))),
        lambda: plan_verdict(labels, draw(VERDICTS)),
        lambda: plan_label_part(labels, draw(st.lists(PARTS, min_size=1, max_size=3))),
    ]
    if labels.parts:
        keys = st.sampled_from(sorted(labels.parts))
        plans.append(lambda: plan_unlabel_part(labels, draw(keys)))
    return plans
