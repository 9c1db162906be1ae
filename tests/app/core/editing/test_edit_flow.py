import pytest
import two_people

from app.core import i18n
from app.core.colours.track_colours import TrackColours
from app.core.editing import (
    EditFlow,
    EditScope,
    PreviewedTracks,
    edits,
    preview_plan,
    preview_trails,
)
from app.core.editing.edit_planner import plan_of
from app.core.editing.edit_texts import rows_changed
from app.core.editing.swap_candidates import find_swap_candidates
from app.core.projection.trails import floor_points
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import RecordingGeometry
from app.core.tracks.session_tracks import SessionTracks
from tracking.editing import SwapFrame, apply_change, plan_delete, plan_swap
from tracking.errors import EditError
from tracking.tracks import Labels

FPS = 20.0


@pytest.fixture
def japanese():
    i18n.use_language("ja")
    yield
    i18n.use_language("en")


@pytest.fixture
def table():
    return two_people.table()


def _on(table) -> EditContext:
    return EditContext(table, Labels(), RecordingGeometry(None, two_people.FRAMES, FPS, (640, 480)))


def _swap(table, frame=30) -> EditFlow:
    flow = EditFlow.begin(edits.SWAP, 4, frame, FPS)
    return flow.with_other(7, (SwapFrame(50, 0.9, "they meet"), SwapFrame(61, 0.1, "7 is lost")))


def _planned(flow, table, problem=""):
    return preview_plan(flow, _on(table), problem)


def test_a_swap_waits_for_the_other_person(table):
    flow = EditFlow.begin(edits.SWAP, 4, 30, FPS)
    assert flow.needs_other
    with pytest.raises(EditError, match="click on them"):
        plan_of(flow, _on(table))
    assert not flow.with_other(7).needs_other


def test_a_person_cannot_be_the_other_one_of_their_own_swap(table):
    assert EditFlow.begin(edits.SWAP, 4, 30, FPS).with_other(4).needs_other


def test_a_swap_is_proposed_where_two_changed_over(table):
    apply_change(table, Labels(), plan_swap(table, 4, 7, 50))
    cuts = find_swap_candidates(_on(table), 4, 7, 30)
    flow = EditFlow.begin(edits.SWAP, 4, 30, FPS).with_other(7, cuts)
    assert abs(flow.cut - 50) <= 3
    assert flow.proposed


def test_the_frames_found_are_gone_through_and_round_again(table):
    flow = _swap(table)
    seen = [flow.at_cut(flow.cut_number + step) for step in (0, 1, 2, -1)]
    assert [one.cut for one in seen] == [50, 61, 50, 61]
    assert [one.end - one.cut for one in seen] == [20] * 4


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
    for _ in range(5):
        stops.append((flow.scope, flow.start, flow.stop))
        flow = flow.with_choice(0, flow.chosen(0) + 1)
    cut = flow.cut
    assert stops == [
        (EditScope.ON, cut, None),
        (EditScope.RANGE, cut, cut + 20),
        (EditScope.FRAME, cut, cut + 1),
        (EditScope.WHOLE, 0, None),
        (EditScope.ON, cut, None),
    ]


def test_a_range_the_user_has_set_is_the_one_that_is_meant():
    flow = EditFlow.begin(edits.DELETE, 4, 30, FPS, marked=(12, 18))
    assert (flow.cut, flow.stop) == (30, None)
    ranged = flow.with_scope(EditScope.RANGE)
    assert (ranged.cut, ranged.stop) == (12, 18)


@pytest.mark.parametrize(("frame", "stop"), [(11, 12), (12, 18), (17, 18), (18, 19)])
def test_an_edit_of_one_frame_goes_over_the_range_that_is_set_around_it(frame, stop):
    flow = EditFlow.begin(edits.OCCLUDE, 4, frame, FPS, marked=(12, 18))
    assert (flow.cut, flow.stop) == (12 if 12 <= frame < 18 else frame, stop)


@pytest.mark.usefixtures("japanese")
def test_why_an_edit_cannot_be_done_is_said_in_the_language_of_the_window(table):
    (why,) = _planned(EditFlow.begin(edits.SHOW, 4, 30, FPS), table).scene.details
    assert "フレーム 30" in why
    assert not set("abcdefghijklmnopqrstuvwxyz") & set(why)


def test_a_split_has_one_scope_and_ignores_others():
    flow = EditFlow.begin(edits.SPLIT, 4, 30, FPS)
    assert flow.with_choice(0, 2) == flow


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        (edits.SPLIT, "Split 4 at frame 30; the rest is 8"),
        (edits.DELETE, "Delete 4 from frame 30 on"),
    ],
)
def test_an_edit_of_one_person_is_ready_at_once(table, kind, words):
    planned = _planned(EditFlow.begin(kind, 4, 30, FPS), table)
    assert planned.scene.ready
    assert planned.scene.title == words


def test_a_preview_says_scope_frame_and_what_changes(table):
    planned = _planned(_swap(table), table)
    scene = planned.scene
    (row,) = scene.choices
    assert (row.chosen, row.key) == (0, "R")
    assert row.options == ("from here on", "this range", "this frame", "the whole track")
    assert scene.other == 7
    assert f"frame {scene.frame}" in scene.title.lower()
    assert scene.cuts[0].chosen
    assert scene.cuts[0].why in scene.details[0]
    assert "frames of 4" in scene.details[1]
    assert scene.hint.startswith("Left / Right move the frame")
    assert scene.hint.endswith("R changes the scope")


def test_a_preview_that_does_not_apply_says_why_and_is_not_ready(table):
    flow = EditFlow.begin(edits.SPLIT, 4, 0, FPS)
    planned = _planned(flow, table)
    assert not planned.scene.ready
    assert planned.change is None
    assert "cannot be split at 0" in planned.scene.details[0]


def test_planning_does_not_touch_the_tracks(table):
    before = table.columns()["track"].tolist()
    _planned(_swap(table), table)
    assert table.columns()["track"].tolist() == before


def test_the_trails_after_a_swap_change_over_at_the_cut(table):
    planned = _planned(_swap(table), table)
    trails = preview_trails(planned, floor_points, TrackColours().of)
    assert [trail.after for trail in trails] == [False, False, True, True]
    was, now = trails[0].points, trails[2].points
    assert was[0, 0] < 0 < was[-1, 0]  # 4 walked to the right
    assert now[0, 0] < 0
    assert now[-1, 0] < 0  # and turns back where it takes over 7's way


def test_a_merge_counts_all_rows_of_the_second_person(table):
    flow = EditFlow.begin(edits.MERGE, 4, 30, FPS).with_other(7)
    change = plan_of(flow, _on(table))
    new, gone, changed = rows_changed(change, table)
    assert sum(gone.values()) + sum(changed.values()) == 90
    assert not new
    assert not flow.has_cut


def test_a_merge_asks_whom_to_keep_where_both_stand(table):
    flow = EditFlow.begin(edits.MERGE, 4, 30, FPS).with_other(7)
    scene = _planned(flow, table).scene
    row = scene.choices[0]
    assert row.title == "Frames of both"
    assert row.options == ("keep 4", "keep 7", "keep the more certain one")
    assert "4 is kept" in scene.title
    other = _planned(flow.with_choice(0, 1), table).scene
    assert "7 is kept" in other.title
    assert other.choices[0].chosen == 1
    assert flow.with_choice(0, 3) == flow


def test_a_merge_can_fill_what_lies_between_the_two(table):
    apply_change(table, Labels(), plan_delete(table, 7, 10, 60))
    apply_change(table, Labels(), plan_delete(table, 4, 40, None))
    flow = EditFlow.begin(edits.MERGE, 4, 30, FPS).with_other(7)
    left, filled = (plan_of(flow.with_choice(1, n), _on(table)) for n in (0, 1))
    assert len(left.after.rows["frame"]) == 0
    assert filled.after.rows["frame"].tolist() == list(range(40, 60))


def test_the_rows_of_a_frame_are_previewed_as_applying_the_change_leaves_them(table):
    change = plan_of(_swap(table).with_scope(EditScope.RANGE), _on(table))
    seen = PreviewedTracks(SessionTracks(table, None), change)
    previewed = [seen.of_frame(frame) for frame in range(two_people.FRAMES)]
    apply_change(table, Labels(), change)
    for frame, rows in enumerate(previewed):
        for name, column in table.of_frame(frame).items():
            assert rows[name].tolist() == pytest.approx(column.tolist(), nan_ok=True)


@pytest.mark.parametrize("start", [0, 40, 99])
def test_deleted_rows_are_not_previewed_and_others_stay(table, start):
    change = plan_of(EditFlow.begin(edits.DELETE, 4, start, FPS), _on(table))
    seen = PreviewedTracks(SessionTracks(table, None), change)
    for frame in (start - 1, start, 99):
        here = table.of_frame(frame)["track"].tolist() if frame >= 0 else []
        wanted = [track for track in here if track != 4 or frame < start]
        assert seen.of_frame(frame)["track"].tolist() == wanted


def test_a_problem_with_the_other_person_is_said_first(table):
    flow = EditFlow.begin(edits.SWAP, 4, 30, FPS)
    scene = _planned(flow, table, "There is no track 99").scene
    assert scene.details[0] == "There is no track 99"
    assert scene.other == 0
    assert not scene.ready


def test_two_who_are_never_near_the_users_frame_are_still_compared(table):
    apply_change(table, Labels(), plan_swap(table, 4, 7, 50))
    assert find_swap_candidates(_on(table), 4, 7, 9_000)[0].frame == pytest.approx(50, abs=3)
