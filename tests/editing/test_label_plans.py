"""Planners of part labels, drawn things, reviewed ranges and verdicts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from label_edits import PARTS, VERDICTS, label_plans
from tables_of_people import table_at, table_of

from tracking.editing import (
    Change,
    LabelState,
    apply_change,
    plan_delete,
    plan_label_part,
    plan_lines,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_occluders,
    plan_reassign,
    plan_regions,
    plan_swap,
    plan_unlabel_part,
    plan_unmark_reviewed,
    plan_verdict,
    plan_verdicts,
    state_as_text,
    state_from_text,
    with_parts_carried,
    with_verdict,
)
from tracking.errors import EditError
from tracking.tracks import (
    CORRECTED_COLUMNS,
    CountingLine,
    Labels,
    Occluder,
    PartLabel,
    PartLabels,
    Region,
    ReviewedRange,
    TrackTable,
    Verdict,
    empty,
)
from tracking.translation import msg

BOX = (10.0, 20.0, 30.0, 40.0)
HEAD = PartLabel(5, 4, 0, BOX)
SQUARE = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
CROSSING = Verdict("crossing", (4, 7), 834, "dismissed")
PLACES = st.sets(st.tuples(st.integers(0, 12), st.integers(1, 5)), max_size=40).map(sorted)


def made(labels: Labels, *changes: Change) -> Labels:
    table = table_of({4: [(0, 900)], 7: [(0, 900)]})
    for change in changes:
        labels = apply_change(table, labels, change)
    return labels


@settings(max_examples=150, deadline=None)
@given(st.data())
def test_every_edit_of_labels_has_an_exact_inverse_and_comes_back_from_text(
    data: st.DataObject,
) -> None:
    table, labels = table_at(data.draw(PLACES)), Labels()
    for _ in range(6):
        try:
            change = data.draw(st.composite(planned)(table, labels))
        except EditError:
            continue
        read = replace(
            change,
            before=state_from_text(state_as_text(change.before)),
            after=state_from_text(state_as_text(change.after)),
        )
        assert read.before.labels == change.before.labels
        assert read.after.labels == change.after.labels
        after = apply_change(table, labels, read)
        assert apply_change(table, after, read.inverse) == labels
        labels = after


def planned(draw: st.DrawFn, table: TrackTable, labels: Labels) -> Change:
    return draw(st.sampled_from(label_plans(draw, table, labels)))()


# Parts


def test_a_part_is_labelled_labelled_anew_and_unlabelled() -> None:
    change = plan_label_part(Labels(), HEAD)
    assert change.text == "Label the head of 4 in frame 5: on its part"
    assert (change.frame, change.tracks) == (5, (4,))
    labels = made(Labels(), change)
    unsure = plan_label_part(labels, replace(HEAD, on_part=None))
    assert unsure.text.endswith(": unsure")
    assert made(labels, unsure).parts[5, 4, 0].on_part is None
    assert made(labels, plan_unlabel_part(labels, (5, 4, 0))) == Labels()


def test_several_parts_are_one_edit() -> None:
    several = [replace(HEAD, frame=frame, part=part) for frame in (5, 9) for part in (0, 1)]
    change = plan_label_part(Labels(), several)
    assert change.text == "Label 4 parts in frames 5 to 9"
    labels = made(Labels(), change)
    assert plan_unlabel_part(labels, *labels.parts).text == (
        "Delete the label of 4 parts in frames 5 to 9"
    )
    more = plan_label_part(labels, [*several, replace(HEAD, frame=6)])
    assert len(more.after.labels.parts) == 1


@given(st.lists(PARTS, min_size=1, max_size=6, unique_by=lambda label: label.key))
def test_an_edit_of_parts_names_only_those_it_changes(given_labels: list[PartLabel]) -> None:
    labels = Labels(parts=PartLabels(given_labels[1:]))
    change = plan_label_part(labels, given_labels)
    assert change.after.labels == LabelState(parts=(given_labels[0],))


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda: plan_label_part(Labels(), replace(HEAD, part=3)), "part 3 is none"),
        (lambda: plan_label_part(Labels(), replace(HEAD, track=0)), "track 0"),
        (lambda: plan_label_part(Labels(), replace(HEAD, frame=-1)), "frame -1"),
        (lambda: plan_label_part(Labels(), replace(HEAD, frame=2**31)), "frames are 0 to"),
        (lambda: plan_label_part(Labels(), replace(HEAD, box=(0, 0, 0, 5))), "positive width"),
        (lambda: plan_label_part(Labels(), replace(HEAD, box=(np.nan, 0, 1, 5))), "box"),
        (lambda: plan_label_part(Labels(), replace(HEAD, box=(0, 0, 1e300, 5))), "box"),
        (lambda: plan_label_part(Labels(), replace(HEAD, source="me")), "source 'me'"),
        (lambda: plan_label_part(Labels(), [HEAD, HEAD]), "labelled twice"),
        (lambda: plan_label_part(Labels(), []), "nothing to change"),
        (lambda: plan_unlabel_part(Labels(), (5, 4, 0)), "has no label in frame 5"),
        (lambda: plan_unlabel_part(Labels()), "no part is named"),
    ],
)
def test_part_labels_that_can_be_none_are_refused(plan: Callable[[], Change], why: str) -> None:
    with pytest.raises(EditError, match=why) as told:
        plan()
    assert "\n" not in str(told.value)


def test_labels_go_along_where_rows_go_from_track_to_track() -> None:
    table = table_of({1: [(0, 20)], 2: [(0, 20)], 3: [(20, 30)]})
    parts = [PartLabel(frame, track, 0, BOX) for frame in (4, 15) for track in (1, 2)]
    labels = Labels(parts=PartLabels([*parts, PartLabel(25, 3, 1, BOX)]))
    swap = with_parts_carried(plan_swap(table, 1, 2, 10), labels)
    assert [label.frame for label in swap.after.labels.parts] == [15, 15]
    given_away = with_parts_carried(plan_reassign(table, 3, 1), labels)
    after = apply_change(table, labels, given_away)
    assert after.parts[25, 1, 1].box == BOX
    assert apply_change(table, after, given_away.inverse) == labels


def test_of_a_row_that_leaves_for_another_the_labels_leave_too() -> None:
    table = table_of({1: [(0, 20)], 2: [(10, 30)]})
    own, other = PartLabel(15, 1, 0, BOX), PartLabel(15, 2, 1, (1.0, 2.0, 3.0, 4.0))
    labels = Labels(parts=PartLabels([own, other]))
    change = with_parts_carried(plan_merge_tracks(table, 1, [2], "second"), labels)
    after = apply_change(table, labels, change)
    assert list(after.parts) == [(15, 1, 1)]
    assert apply_change(table, after, change.inverse) == labels


def test_an_edit_that_moves_no_row_carries_no_label() -> None:
    table = table_of({1: [(0, 20)]})
    labels = Labels(parts=PartLabels([PartLabel(5, 1, 0, BOX)]))
    change = plan_delete(table, 1, 3, 9)
    assert with_parts_carried(change, labels) is change


# Drawn things


def test_things_drawn_are_sorted_by_name_and_said_by_it() -> None:
    hall, door = Region("hall", SQUARE), Region("  by the \n door ", SQUARE)
    first = plan_regions(Labels(), [hall])
    labels = made(Labels(), first)
    second = plan_regions(labels, [hall, door])
    assert [region.name for region in made(labels, second).regions] == ["by the door", "hall"]
    assert (first.text, second.text) == ('Draw region "hall"', 'Draw region "by the door"')
    moved = plan_regions(labels, [replace(hall, polygon=SQUARE[:3])])
    named = plan_regions(labels, [replace(hall, name="lobby")])
    gone = plan_regions(labels, [])
    assert moved.text == 'Change region "hall"'
    assert named.text == 'Put region "lobby" in place of "hall"'
    assert gone.text == 'Delete region "hall"'
    many = plan_regions(labels, [Region(name, SQUARE) for name in "abc"])
    assert many.text == "Change regions: 3 drawn, 1 deleted"
    assert many.text.values["several"] == "regions"  # a word of its own in any language


def test_an_edit_of_one_line_does_not_name_the_others() -> None:
    lines = [CountingLine(name, (0.0, 0.0), (1.0, 0.0)) for name in ("a", "b", "c")]
    labels = made(Labels(), plan_lines(Labels(), lines))
    change = plan_lines(labels, lines[1:])
    assert change.before.labels.lines == (lines[0],)
    assert change.after.labels == LabelState()


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda: plan_lines(Labels(), [CountingLine("a", (1, 1), (1, 1))]), "has no length"),
        (lambda: plan_lines(Labels(), [CountingLine("a", (1, 1), (np.inf, 1))]), "no place"),
        (lambda: plan_lines(Labels(), [CountingLine(" ", (1, 1), (2, 1))]), "needs a name"),
        (lambda: plan_lines(Labels(), [CountingLine("a" * 300, (1, 1), (2, 1))]), "at most 200"),
        (
            lambda: plan_lines(
                Labels(),
                [CountingLine("a", (1, 1), (2, 1)), CountingLine(" a", (1, 1), (3, 1))],
            ),
            "two counting lines are called 'a'",
        ),
        (lambda: plan_lines(Labels(), []), "nothing to change"),
        (lambda: plan_regions(Labels(), [Region("a", SQUARE[:2])]), "three or more"),
        (
            lambda: plan_regions(Labels(), [Region("a", (*SQUARE[:2], SQUARE[3], SQUARE[2]))]),
            "edges cross",
        ),
        (lambda: plan_regions(Labels(), [Region("a", SQUARE * 200)]), "at most 500"),
        (lambda: plan_occluders(Labels(), [Occluder("", SQUARE)]), "needs a name"),
        (lambda: plan_occluders(Labels(), [Occluder("a\0b", SQUARE)]), "zero character"),
    ],
)
def test_things_that_cannot_be_drawn_are_refused(plan: Callable[[], Change], why: str) -> None:
    with pytest.raises(EditError, match=why) as told:
        plan()
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(
    ("polygon", "sound"),
    [
        (SQUARE, True),
        (SQUARE[::-1], True),
        (((0, 0), (4, 0), (4, 4), (2, 1), (0, 4)), True),  # a notch
        (((0, 0), (2, 0), (1, 0), (1, 2)), False),  # goes back on itself
        (((0, 0), (2, 0), (4, 0), (4, 2)), True),  # a corner that is none
        (((0, 0), (4, 0), (2, 0), (2, 3), (1, 3)), False),
        (((0, 0), (4, 0), (4, 4), (2, 0), (0, 4)), False),  # touches its own edge
        (((0, 0), (0, 0), (1, 0), (1, 1)), False),  # a corner twice
        (((0, 0), (1, 0), (2, 0)), False),  # no area
        (((0, 0), (1, 0), (1, 1), (2, 0), (3, 0), (3, 5), (0, 5)), True),  # edges on one line
    ],
)
def test_regions_are_polygons_whose_edges_meet_only_in_their_corners(
    polygon: tuple[tuple[float, float], ...], sound: bool
) -> None:
    try:
        plan_regions(Labels(), [Region("a", polygon)])
    except EditError:
        assert not sound
    else:
        assert sound


# What was looked at


def test_several_tracks_are_marked_and_unmarked_at_once() -> None:
    marked = plan_mark_reviewed(Labels(), (7, 4), 10, 20)
    assert marked.text == "Mark tracks 4 and 7 as reviewed in frames 10 to 19"
    labels = made(Labels(), marked)
    assert labels.reviewed == (ReviewedRange(4, 10, 20), ReviewedRange(7, 10, 20))
    unmarked = plan_unmark_reviewed(labels, 4, 12, 15)
    assert unmarked.text == "Unmark track 4 as reviewed in frames 12 to 14"
    assert made(labels, unmarked).reviewed == (
        *(ReviewedRange(4, 10, 12), ReviewedRange(4, 15, 20)),
        ReviewedRange(7, 10, 20),
    )
    assert made(labels, plan_unmark_reviewed(labels, 0, 0, 100)) == Labels()


def test_only_frames_in_which_a_track_has_rows_are_marked() -> None:
    seen = np.array([*range(10, 20), *range(30, 35)], np.int32)
    columns = empty(CORRECTED_COLUMNS)
    rows = {name: np.zeros(len(seen), column.dtype) for name, column in columns.items()}
    table = TrackTable({**rows, "frame": seen, "track": np.full(len(seen), 4, np.int32)})
    change = plan_mark_reviewed(Labels(), 4, 0, 100, table)
    assert change.after.labels.reviewed == (ReviewedRange(4, 10, 20), ReviewedRange(4, 30, 35))
    assert change.text == "Mark track 4 as reviewed in frames 10 to 34"
    everybody = plan_mark_reviewed(Labels(), 0, 0, 100, table)
    assert everybody.after.labels.reviewed == (ReviewedRange(0, 0, 100),)
    with pytest.raises(EditError, match="track 4: no boxes in frames 20 to 29"):
        plan_mark_reviewed(Labels(), 4, 20, 30, table)
    with pytest.raises(EditError, match="9"):
        plan_mark_reviewed(Labels(), 9, 0, 100, table)


def test_an_edit_of_reviewed_ranges_names_only_those_it_changes() -> None:
    labels = Labels(reviewed=tuple(ReviewedRange(4, at, at + 5) for at in range(0, 5000, 10)))
    change = plan_mark_reviewed(labels, 4, 5, 7)
    assert change.before.labels.reviewed == (ReviewedRange(4, 0, 5),)
    assert change.after.labels.reviewed == (ReviewedRange(4, 0, 7),)


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda seen: plan_mark_reviewed(seen, 0, 12, 15), "marked as reviewed already"),
        (lambda seen: plan_mark_reviewed(seen, (), 12, 15), "no track is named"),
        (lambda seen: plan_mark_reviewed(seen, -3, 12, 15), "track -3"),
        (lambda seen: plan_unmark_reviewed(seen, 4, 12, 15), "for all tracks together"),
        (lambda seen: plan_unmark_reviewed(seen, 4, 50, 60), "track 4: not marked"),
        (lambda seen: plan_unmark_reviewed(seen, 0, 60, 50), "range is empty"),
    ],
)
def test_marks_that_change_nothing_are_refused(plan: Callable[[Labels], Change], why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan(Labels(reviewed=(ReviewedRange(0, 10, 20),)))


def test_a_verdict_is_given_changed_and_taken_back() -> None:
    change = plan_verdict(Labels(), CROSSING, "4 and 7 cross")
    assert (change.text, change.frame) == ("Dismiss: 4 and 7 cross", 834)
    labels = made(Labels(), change)
    changed = plan_verdict(labels, replace(CROSSING, decision="right"))
    assert changed.text == "Looked at, right: crossing of 4 and 7 in frame 834"
    assert made(labels, changed).verdicts[CROSSING.key].decision == "right"
    assert made(labels, change.inverse) == Labels()


@given(VERDICTS)
def test_a_fix_and_its_verdict_are_undone_together(verdict: Verdict) -> None:
    table = table_of({1: [(0, 20)], 2: [(0, 20)]})
    change = with_verdict(plan_swap(table, 1, 2, 5), Labels(), verdict)
    labels = apply_change(table, Labels(), change)
    assert labels.verdicts == {verdict.key: verdict}
    assert apply_change(table, labels, change.inverse) == Labels()


def test_verdicts_that_say_nothing_new_are_refused() -> None:
    labels = made(Labels(), plan_verdict(Labels(), CROSSING))
    with pytest.raises(EditError, match="is dismissed already"):
        plan_verdict(labels, CROSSING)
    with pytest.raises(EditError, match="decision 'maybe'"):
        plan_verdict(labels, replace(CROSSING, decision="maybe"))
    with pytest.raises(EditError, match="needs a name"):
        plan_verdict(labels, replace(CROSSING, kind=""))


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (LabelState(parts=(HEAD,)), LabelState()),
        (LabelState(), LabelState(verdicts=(CROSSING,))),
        (LabelState(lines=(CountingLine("a", (0, 0), (1, 0)),)), LabelState()),
        (LabelState(), LabelState(reviewed=(ReviewedRange(0, 10, 20),))),
        (LabelState(), LabelState(parts=(replace(HEAD, frame=6), replace(HEAD, frame=6)))),
    ],
)
def test_labels_that_are_not_as_planned_on_are_not_changed(
    before: LabelState, after: LabelState
) -> None:
    labels = Labels(
        reviewed=(ReviewedRange(0, 10, 20),), verdicts={CROSSING.key: replace(CROSSING)}
    )
    table = table_of({1: [(0, 20)]})
    change = plan_delete(table, 1)
    change = replace(
        change,
        before=replace(change.before, labels=before),
        after=replace(change.after, labels=after),
    )
    with pytest.raises(EditError, match="not what the edit was planned on"):
        apply_change(table, labels, change)
    assert 1 in table


def test_many_verdicts_are_one_change_and_one_undo() -> None:
    others = [Verdict("jump", (track,), 10 * track, "right") for track in (4, 7)]
    before = made(Labels(), plan_verdict(Labels(), others[0]))
    change = plan_verdicts(before, others, msg("two"))
    after = made(before, change)
    assert set(after.verdicts.values()) == set(others)
    assert made(after, change.inverse) == before
    assert change.frame == 70  # of the one that was not said yet


def test_verdicts_said_already_or_of_two_minds_are_refused() -> None:
    labels = made(Labels(), plan_verdict(Labels(), CROSSING))
    with pytest.raises(EditError, match="already"):
        plan_verdicts(labels, [CROSSING], msg("one"))
    two = [
        replace(CROSSING, frame=frame, decision=said)
        for frame, said in ((1, "right"), (2, "dismissed"))
    ]
    with pytest.raises(EditError, match="one decision"):
        plan_verdicts(labels, two, msg("two"))
