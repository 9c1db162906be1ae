import numpy as np
import pytest
import two_people

from app.core.tracks.live_tracks import LiveTracks
from app.core.tracks.session_tracks import SessionTracks
from tracking.editing import apply_change, plan_delete, plan_merge_tracks, plan_split, plan_swap
from tracking.tracks import Labels, TrackTable


def _live() -> LiveTracks:
    live = LiveTracks()
    for at in range(0, two_people.FRAMES, 7):
        live.extend(two_people.steps()[at : at + 7])
    return live


def _saved() -> SessionTracks:
    return SessionTracks(two_people.table(), two_people.run())


@pytest.mark.parametrize("shown", [_live(), _saved()], ids=["live", "session"])
class TestLiveAndSavedTracksAnswerAlike:
    def test_the_frames_that_were_tracked(self, shown):
        assert shown.frames == (0, 100)
        assert list(shown.ids) == [4, 7]

    def test_the_people_of_a_frame(self, shown):
        assert shown.of_frame(5)["track"].tolist() == [4]
        assert shown.of_frame(50)["track"].tolist() == [4, 7]
        assert shown.of_frame(100)["track"].tolist() == []

    def test_the_recent_rows_of_the_people_of_a_frame(self, shown):
        rows = shown.recent(12, back=5)
        assert sorted(rows["frame"][rows["track"] == 4].tolist()) == [7, 8, 9, 10, 11, 12]
        assert rows["frame"][rows["track"] == 7].tolist() == [10, 11, 12]

    def test_a_whole_track(self, shown):
        assert shown.of_track(7)["frame"].tolist() == list(range(10, 100))
        assert shown.of_track(99)["frame"].tolist() == []

    def test_the_particles_of_a_frame(self, shown):
        assert shown.particles(50)["track"].tolist() == [4] * 5 + [7] * 5
        assert len(shown.particles(2000)["track"]) == 0

    def test_nothing_measured_is_no_rows(self, shown):
        assert len(shown.detections(3)["frame"]) == 0

    def test_stretches_split_where_people_are_only_predicted(self, shown):
        spans = shown.spans()
        assert spans[4].tolist() == [[0, 100, 0]]
        assert spans[7].tolist() == [[10, 60, 0], [60, 70, 1], [70, 100, 0]]

    def test_people_per_frame(self, shown):
        counts = shown.activity(120)
        assert counts[[0, 9, 10, 99, 100]].tolist() == [1, 1, 2, 2, 0]


def test_nothing_tracked_yet_is_shown_as_nothing():
    live = LiveTracks()
    assert live.frames == (0, 0)
    assert len(live.recent(5, back=3)["frame"]) == 0
    assert live.spans() == {}


def test_stretches_split_at_gaps():
    rows = two_people.columns()
    kept = ~np.isin(rows["frame"], [20, 21])
    table = TrackTable({name: column[kept] for name, column in rows.items()})
    spans = SessionTracks(table, None).spans()
    assert spans[4].tolist() == [[0, 20, 0], [22, 100, 0]]


def test_particles_take_the_ids_their_person_has_after_a_swap():
    table = two_people.table()
    apply_change(table, Labels(), plan_swap(table, 4, 7, 50))
    shown = SessionTracks(table, two_people.run())
    before, after = shown.particles(49), shown.particles(51)
    assert before["track"].tolist() == [4] * 5 + [7] * 5
    assert after["track"].tolist() == [7] * 5 + [4] * 5


def _after(*plans):
    table, labels = two_people.table(), Labels()
    for plan in plans:
        apply_change(table, labels, plan(table))
    return SessionTracks(table, two_people.run(measured=True))


def test_a_person_who_was_taken_out_leaves_neither_particles_nor_a_measured_dot():
    shown = _after(lambda table: plan_delete(table, 4, 30, 60))
    assert shown.particles(29)["track"].tolist() == [4] * 5 + [7] * 5
    assert shown.particles(30)["track"].tolist() == [7] * 5
    assert shown.detections(30)["track"].tolist() == [7]
    assert shown.detections(60)["track"].tolist() == [4, 7]


def test_particles_go_to_the_new_id_after_a_split():
    shown = _after(lambda table: plan_split(table, 4, 50))
    new = next(track for track in shown.ids if track not in (4, 7))
    assert shown.particles(49)["track"].tolist() == [4] * 5 + [7] * 5
    assert shown.particles(50)["track"].tolist() == [new] * 5 + [7] * 5


def test_of_two_who_are_merged_only_the_kept_ones_particles_stay():
    shown = _after(lambda table: plan_merge_tracks(table, 4, [7]))
    assert shown.particles(50)["track"].tolist() == [4] * 5


def test_who_was_swapped_and_then_taken_out_is_followed_through_both():
    shown = _after(
        lambda table: plan_swap(table, 4, 7, 20), lambda table: plan_delete(table, 4, 50, 60)
    )
    assert shown.particles(55)["track"].tolist() == [7] * 5
    assert shown.particles(65)["track"].tolist() == [7] * 5 + [4] * 5


def test_a_row_that_was_moved_a_little_by_hand_keeps_its_particles():
    rows = {name: column.copy() for name, column in two_people.columns().items()}
    rows["left"][rows["track"] == 4] += 8
    shown = SessionTracks(TrackTable(rows), two_people.run())
    assert shown.particles(20)["track"].tolist() == [4] * 5 + [7] * 5


def test_tracks_without_a_run_have_no_particles():
    shown = SessionTracks(two_people.table(), None)
    assert shown.frames == (0, 100)
    assert len(shown.particles(50)["track"]) == 0


def test_an_empty_table_shows_nobody():
    shown = SessionTracks(TrackTable(), None)
    assert shown.frames == (0, 0)
    assert shown.spans() == {}


def test_stretches_asked_for_while_a_tracker_works_grow_with_it():
    live, steps = LiveTracks(), two_people.steps()
    live.extend(steps[:50])
    before = live.spans()
    live.extend(steps[50:])
    assert before[4].tolist() == [[0, 50, 0]]
    assert live.spans()[4].tolist() == [[0, 100, 0]]
