"""One id for each person's whole stay."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from linked_runs import (
    BLUE,
    FPS,
    RED,
    VIEW,
    Stretch,
    corrected,
    id_near,
    ids_at,
    link_run,
    run_of,
    straight,
)

from tracking.trackers.linking import link_tracks
from tracking.tracks import Run

A, B = straight((-2, 6), (2, 6.5), 120), straight((2, 6), (-2, 6.5), 120)
"""Two who pass through each other in the middle."""
OUT = straight((-1, 6), (-3.9, 6), 60)
IN = straight((-3.9, 6.4), (-1, 6.4), 60)


def exchanged(one: tuple[float, ...] = RED, other: tuple[float, ...] = BLUE) -> Run:
    """Where they met, the tracker took each for the other."""
    return run_of(
        Stretch(1, 0, A[:60], one),
        Stretch(2, 0, B[:60], other),
        Stretch(2, 60, A[60:], one),
        Stretch(1, 60, B[60:], other),
        frames=120,
    )


def test_two_who_were_exchanged_where_they_met_get_their_own_ids_back() -> None:
    run = link_run(exchanged(), VIEW, FPS)
    assert (id_near(run, 5, A[5]), id_near(run, 5, B[5])) == (1, 2)
    assert (id_near(run, 115, A[115]), id_near(run, 115, B[115])) == (1, 2)


def test_in_clothes_of_one_colour_walking_alone_tells_them_apart() -> None:
    run = link_run(exchanged(RED, RED), VIEW, FPS)
    assert (id_near(run, 115, A[115]), id_near(run, 115, B[115])) == (1, 2)


def test_two_dressed_alike_who_were_exchanged_while_neither_was_seen_get_their_ids_back() -> None:
    one, other = straight((-2, 6), (2, 6.3), 120), straight((2, 6.75), (-2, 6.45), 120)
    tracked = run_of(
        Stretch(1, 0, one[:66], lost=range(55, 66)),
        Stretch(2, 0, other[:66], lost=range(55, 66)),
        Stretch(2, 66, one[66:]),
        Stretch(1, 66, other[66:]),
        frames=120,
    )
    run = link_run(tracked, VIEW, FPS)
    assert (id_near(run, 115, one[115]), id_near(run, 115, other[115])) == (1, 2)


def test_two_who_passed_and_were_not_exchanged_stay() -> None:
    run = run_of(Stretch(1, 0, A, RED), Stretch(2, 0, B, BLUE), frames=120)
    assert link_run(run, VIEW, FPS).tracks["track"].tolist() == run.tracks["track"].tolist()


def test_two_who_meet_and_turn_back_stay_themselves() -> None:
    way, other = np.concatenate((A[:55], A[54::-1])), np.concatenate((B[:55], B[54::-1]))
    run = run_of(Stretch(1, 0, way, RED), Stretch(2, 0, other, BLUE), frames=110)
    assert link_run(run, VIEW, FPS).tracks["track"].tolist() == run.tracks["track"].tolist()


def hidden(clothes: tuple[float, ...] = RED) -> Run:
    """Somebody passes behind something, and is detected again under another id."""
    way = straight((-1.5, 6), (1.5, 6), 140)
    return run_of(
        Stretch(1, 0, way[:70], RED, lost=range(50, 70)),
        Stretch(4, 90, way[90:], clothes),
        Stretch(2, 0, straight((-2, 9), (2, 9.5), 140), BLUE),
        frames=140,
    )


def test_who_was_hidden_keeps_the_id_and_stands_in_every_frame() -> None:
    run = link_run(hidden(), VIEW, FPS)
    assert id_near(run, 130, (1.3, 6)) == 1
    own = run.tracks["track"] == 1
    assert run.tracks["frame"][own].tolist() == list(range(140))
    predicted = run.tracks["frame"][own & run.tracks["predicted"]]
    assert predicted.tolist() == list(range(50, 90))
    np.testing.assert_allclose(run.tracks["x"][own], np.linspace(-1.5, 1.5, 140), atol=0.15)


def test_in_a_long_gap_nobody_is_said_to_stand_anywhere() -> None:
    way = straight((-1.5, 6), (1.5, 6), 140)
    run = link_run(run_of(Stretch(1, 0, way[:45]), Stretch(1, 90, way[90:]), frames=140), VIEW, FPS)
    assert run.tracks["frame"].tolist() == [*range(45), *range(90, 140)]
    assert set(run.tracks["track"].tolist()) == {1}


def test_gaps_are_filled_no_longer_than_a_tracker_is_sure_about() -> None:
    way = straight((-1.5, 6), (1.5, 6), 140)
    run = run_of(Stretch(1, 0, way[:50]), Stretch(1, 70, way[70:]), frames=140)
    for longest_gap_s, filled in ((1.5, range(140)), (0.5, [*range(50), *range(70, 140)])):
        linked = link_tracks(run, VIEW, FPS, longest_gap_s=longest_gap_s)
        assert linked.tracks["frame"].tolist() == list(filled)
        assert set(linked.tracks["track"].tolist()) == {1}


def test_who_looks_quite_different_after_being_hidden_is_somebody_else() -> None:
    run = link_run(hidden(BLUE), VIEW, FPS)
    assert id_near(run, 130, (1.3, 6)) == 4


def test_who_comes_elsewhere_after_somebody_left_is_somebody_else() -> None:
    run = run_of(Stretch(1, 0, OUT), Stretch(2, 80, straight((3.9, 6), (1, 6), 60)), frames=140)
    assert link_run(run, VIEW, FPS).tracks["track"].tolist() == run.tracks["track"].tolist()


def test_every_table_tells_the_same_ids() -> None:
    run = link_run(exchanged(), VIEW, FPS)
    rows = {
        (frame, track): x
        for frame, track, x in zip(
            *(run.tracks[name].tolist() for name in ("frame", "track", "x")), strict=True
        )
    }
    for table in (run.detections, run.associations, run.signals):
        keys = list(zip(table["frame"].tolist(), table["track"].tolist(), strict=True))
        assert sorted(keys) == sorted(rows)
    for frame in (5, 115):
        cloud = run.particles.of_frame(frame)
        for track, x in zip(cloud["track"].tolist(), cloud["x"].tolist(), strict=True):
            assert rows[frame, track] == pytest.approx(x, abs=0.2)
    red = run.signals["track"] == 1
    assert run.signals["upper_a"][red].min() > 20 > run.signals["upper_a"][~red].max()


class InAFile:
    """A column that is read by slices."""

    def __init__(self, values: np.ndarray) -> None:
        self.values = values

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, rows: slice) -> np.ndarray:
        return self.values[rows]


def test_particles_in_a_file_are_renamed_as_they_are_read() -> None:
    run = exchanged()
    columns = {
        **run.particles.columns,
        "track": InAFile(np.asarray(run.particles.columns["track"])),
    }
    there = replace(run, particles=replace(run.particles, columns=columns))
    expected, found = (link_run(one, VIEW, FPS).particles for one in (run, there))
    assert not isinstance(found.columns["track"], np.ndarray)
    np.testing.assert_array_equal(np.asarray(found.columns["track"]), expected.columns["track"])
    for frame in (10, 100):
        np.testing.assert_array_equal(
            found.of_frame(frame)["track"], expected.of_frame(frame)["track"]
        )


def test_tracking_again_goes_on_with_the_ids_of_the_rows_that_stand_fast() -> None:
    whole = hidden()
    given = corrected(whole, 0, 50)
    rest = whole.tracks
    later = rest["frame"] >= 50
    run = replace(
        whole,
        tracks={name: column[later] for name, column in rest.items()},
        signals={name: column[later] for name, column in whole.signals.items()},
        frames=(50, 140),
        known_tracks=3,
    )
    found = link_run(run, VIEW, FPS, given)
    assert id_near(found, 130, (1.3, 6)) == 1
    assert found.tracks["frame"].min() == 50


def test_known_people_are_never_made_one() -> None:
    whole = hidden()
    run = replace(whole, known_tracks=4)
    assert id_near(link_run(run, VIEW, FPS), 130, (1.3, 6)) == 4


def test_new_ids_are_above_all_known_ones() -> None:
    elsewhere = Stretch(1, 80, straight((3.9, 6), (1, 6), 60))
    run = run_of(Stretch(1, 0, OUT), elsewhere, frames=140, known_tracks=30)
    assert list(ids_at(link_run(run, VIEW, FPS), 110)) == [31]


def test_the_same_run_gives_the_same_bytes_and_stays_as_it_was() -> None:
    run = exchanged()
    before = {name: column.copy() for name, column in run.tracks.items()}
    one, other = link_run(run, VIEW, FPS), link_run(run, VIEW, FPS)
    for name in before:
        assert one.tracks[name].tobytes() == other.tracks[name].tobytes()
        assert run.tracks[name].tobytes() == before[name].tobytes()


def test_runs_without_signals_and_of_nobody_are_linked_too() -> None:
    run = exchanged()
    blind = replace(run, signals={name: column[:0] for name, column in run.signals.items()})
    assert id_near(link_run(blind, VIEW, FPS), 115, A[115]) == 1
    nobody = replace(blind, tracks={name: column[:0] for name, column in run.tracks.items()})
    assert len(link_run(nobody, VIEW, FPS).tracks["frame"]) == 0


def test_where_somebody_went_who_left_is_not_guessed() -> None:
    run = link_run(run_of(Stretch(1, 0, OUT, lost=range(50, 60)), frames=120), VIEW, FPS)
    assert run.tracks["frame"].max() == 49


def test_who_is_lost_when_the_footage_ends_is_followed_on() -> None:
    run = link_run(run_of(Stretch(1, 0, A, lost=range(112, 120)), frames=120), VIEW, FPS)
    assert run.tracks["frame"].max() == 119


def test_a_few_rows_in_the_middle_of_nowhere_are_nobody() -> None:
    false = Stretch(2, 50, straight((0, 8), (0.05, 8), 2), BLUE)
    run = link_run(run_of(Stretch(1, 0, OUT), false, frames=120), VIEW, FPS)
    assert set(run.tracks["track"].tolist()) == {1}
    assert run.detections["track"].min() == 0


def changed_clothes(other: tuple[float, ...]) -> Run:
    """Two lost for a moment and found under new ids, the second one in these clothes."""
    first, second = straight((-1, 5), (1.3, 5), 138), straight((1, 7), (1, 5), 124)
    return run_of(
        Stretch(1, 20, first[:60]),
        Stretch(2, 98, first[78:]),
        Stretch(3, 200, second[:60]),
        Stretch(4, 262, second[62:], other),
        Stretch(5, 0, straight((-2, 8), (-1.5, 8), 390), BLUE),
        frames=400,
    )


@pytest.mark.parametrize("clothes", [RED, BLUE, (80.0, -40.0, -40.0, 80.0, 30.0, 40.0)])
def test_one_persons_changed_clothes_part_nobody_else(clothes: tuple[float, ...]) -> None:
    run = link_run(changed_clothes(clothes), VIEW, FPS)
    assert id_near(run, 40, (-0.66, 5)) == id_near(run, 150, (1.2, 5)) == 1
