import pytest
import two_people

from app.presenters.edit_flow import EditFlow, EditKind, Scope
from app.presenters.edit_preview import planned_edit, preview_trails, rows_changed
from app.presenters.trails import floor_points
from tracking.editing import apply_change, plan_delete
from tracking.errors import EditError
from tracking.tracks import Labels

FPS = 20.0


@pytest.fixture
def table():
    return two_people.table()


def _swap(table, frame=30) -> EditFlow:
    return EditFlow.begin(EditKind.SWAP, 4, frame, FPS).with_other(7, table)


def test_a_swap_waits_for_the_other_person(table):
    flow = EditFlow.begin(EditKind.SWAP, 4, 30, FPS)
    assert flow.needs_other
    with pytest.raises(EditError, match="click on them"):
        flow.plan(table, Labels())
    assert not flow.with_other(7, table).needs_other


def test_a_person_cannot_be_the_other_one_of_their_own_swap(table):
    assert EditFlow.begin(EditKind.SWAP, 4, 30, FPS).with_other(4, table).needs_other


def test_the_swap_is_proposed_where_the_two_crossed(table):
    flow = _swap(table)
    assert abs(flow.cut - 50) <= 3
    assert flow.proposed


def test_moving_the_cut_takes_the_range_along_and_stays_in_the_recording(table):
    flow = _swap(table).moved(5, two_people.FRAMES)
    assert flow.end - flow.cut == 20
    assert not flow.proposed
    assert flow.moved(999, two_people.FRAMES).cut == 99
    assert flow.moved(-999, two_people.FRAMES).cut == 0


def test_the_end_of_the_range_moves_but_never_before_the_cut(table):
    flow = _swap(table)
    assert flow.with_end_moved(5, two_people.FRAMES).end == flow.end + 5
    assert flow.with_end_moved(-500, two_people.FRAMES).end == flow.cut + 1


def test_the_scope_goes_round_and_says_where_the_edit_ends(table):
    flow = _swap(table)
    stops = []
    for _ in range(4):
        stops.append((flow.scope, flow.stop))
        flow = flow.with_choice(flow.choice + 1)
    cut = flow.cut
    assert stops == [
        (Scope.ON, None),
        (Scope.RANGE, cut + 20),
        (Scope.FRAME, cut + 1),
        (Scope.ON, None),
    ]


def test_a_split_has_one_scope_and_ignores_others():
    flow = EditFlow.begin(EditKind.SPLIT, 4, 30, FPS)
    assert flow.with_choice(2) == flow


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        (EditKind.SPLIT, "Split 4 at frame 30; the rest is 8"),
        (EditKind.DELETE, "Delete 4 from frame 30 on"),
    ],
)
def test_an_edit_of_one_person_is_ready_at_once(table, kind, words):
    planned = planned_edit(EditFlow.begin(kind, 4, 30, FPS), table, Labels(), FPS)
    assert planned.scene.ready
    assert planned.scene.title == words


def test_a_preview_says_scope_frame_and_what_changes(table):
    planned = planned_edit(_swap(table), table, Labels(), FPS)
    scene = planned.scene
    assert scene.choice == 0
    assert scene.choices == ("from here on", "this range", "this frame")
    assert scene.other == 7
    assert f"frame {scene.frame}" in scene.title.lower()
    assert "came closest" in scene.details[0]
    assert "frames of 4" in scene.details[1]
    assert scene.hint == "Left / Right move the frame, R changes how far"


def test_a_preview_that_does_not_apply_says_why_and_is_not_ready(table):
    flow = EditFlow.begin(EditKind.SPLIT, 4, 0, FPS)
    planned = planned_edit(flow, table, Labels(), FPS)
    assert not planned.scene.ready
    assert planned.change is None
    assert "cannot be split at 0" in planned.scene.details[0]


def test_planning_does_not_touch_the_tracks(table):
    before = table.columns()["track"].tolist()
    planned_edit(_swap(table), table, Labels(), FPS)
    assert table.columns()["track"].tolist() == before


def test_the_trails_after_a_swap_change_over_at_the_cut(table):
    planned = planned_edit(_swap(table), table, Labels(), FPS)
    trails = preview_trails(planned, floor_points)
    assert [trail.after for trail in trails] == [False, False, True, True]
    was, now = trails[0].points, trails[2].points
    assert was[0, 0] < 0 < was[-1, 0]  # 4 walked to the right
    assert now[0, 0] < 0
    assert now[-1, 0] < 0  # and turns back where it takes over 7's way


def test_a_merge_counts_all_rows_of_the_second_person(table):
    flow = EditFlow.begin(EditKind.MERGE, 4, 30, FPS).with_other(7, table)
    change = flow.plan(table, Labels())
    assert sum(rows_changed(change, table).values()) == 90
    assert not flow.has_cut


def test_a_merge_asks_whom_to_keep_where_both_stand(table):
    flow = EditFlow.begin(EditKind.MERGE, 4, 30, FPS).with_other(7, table)
    scene = planned_edit(flow, table, Labels(), FPS).scene
    assert scene.choice_title == "Where both stand"
    assert scene.choices == ("keep 4", "keep 7")
    assert "4 is kept" in scene.title
    other = planned_edit(flow.with_choice(1), table, Labels(), FPS).scene
    assert "7 is kept" in other.title
    assert other.choice == 1
    assert flow.with_choice(2) == flow


def test_a_merge_of_people_who_never_stand_together_has_nothing_to_choose(table):
    apply_change(table, Labels(), plan_delete(table, 7, 30, None))
    apply_change(table, Labels(), plan_delete(table, 4, 0, 30))
    flow = EditFlow.begin(EditKind.MERGE, 4, 30, FPS).with_other(7, table)
    scene = planned_edit(flow, table, Labels(), FPS).scene
    assert scene.ready
    assert scene.choices == ()
    assert "R changes" not in scene.hint


def test_a_problem_with_the_other_person_is_said_first(table):
    flow = EditFlow.begin(EditKind.SWAP, 4, 30, FPS)
    scene = planned_edit(flow, table, Labels(), FPS, "There is no track 99").scene
    assert scene.details[0] == "There is no track 99"
    assert scene.other == 0
    assert not scene.ready
