"""The measure by which tracked body parts are right or wrong."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tracking.scoring.parts import (
    PartTruth,
    TrackedParts,
    bounding,
    judge,
    margin,
    rates_of,
    tracked_parts,
    tracked_people,
)

FRAMES = 30
TRUE = np.array([[40.0, 20, 60, 40], [35, 40, 65, 90], [36, 90, 64, 160]])


def _truth(visibility: float = 1.0, frames: int = FRAMES, person: int = 7) -> PartTruth:
    """A person, standing still."""
    parts = np.broadcast_to(TRUE, (frames, 3, 4)).copy()
    people, seen = np.full(frames, person), np.full(frames, visibility)
    return PartTruth(np.arange(frames), people, parts, seen, (200, 200))


def _together(one: PartTruth, other: PartTruth) -> PartTruth:
    """Both in one picture."""
    order = np.argsort(np.concatenate((one.frame, other.frame)), kind="stable")
    names = ("frame", "person", "parts", "visibility")
    rows = {n: np.concatenate((getattr(one, n), getattr(other, n)))[order] for n in names}
    return PartTruth(**rows, size_px=one.size_px)


def _tracked(tables: dict[int, np.ndarray]) -> TrackedParts:
    """Tables (frames, 3, 4) by track."""
    tracks = np.tile(sorted(tables), FRAMES if tables else 0).astype(np.int64)
    frames = np.repeat(np.arange(FRAMES), len(tables))
    parts = np.array([tables[t][f] for t, f in zip(tracks, frames, strict=True)])
    parts = parts.reshape(-1, 3, 4)
    return TrackedParts(frames, tracks, parts, bounding(parts))


def _exact() -> np.ndarray:
    return np.broadcast_to(TRUE, (FRAMES, 3, 4)).copy()


def test_who_is_tracked_exactly_is_right_from_the_first_frame_on() -> None:
    (one,) = judge(_truth(), _tracked({3: _exact()}), 20.0)
    assert (one.person, one.track, one.first_frame, len(one.parts)) == (7, 3, 0, FRAMES)
    assert one.parts.all()
    assert one.person_right.all()


def test_the_first_frame_is_the_one_in_which_a_track_stands_on_the_person() -> None:
    table = _exact()
    table[:5] = np.nan
    (one,) = judge(_truth(), _tracked({3: table}), 20.0)
    assert one.first_frame == 5
    assert one.parts.all()


def test_who_is_tracked_too_late_or_never_is_wrong_from_the_start() -> None:
    table = _exact()
    table[:21] = np.nan
    for tracked in (_tracked({3: table}), _tracked({})):
        (one,) = judge(_truth(), tracked, 20.0)
        assert (one.track, one.first_frame) == (0, 0)
        assert not one.parts.any()
        assert not one.person_right.any()


def test_another_id_on_the_same_person_is_worth_nothing() -> None:
    early, late = _exact(), _exact()
    early[10:] = np.nan
    late[:10] = np.nan
    (one,) = judge(_truth(), _tracked({3: early, 4: late}), 20.0)
    assert one.parts[:10].all()
    assert not one.parts[10:].any()


def test_a_track_belongs_to_whom_it_overlaps_most() -> None:
    shift, behind = np.array([14.0, 0, 14, 0]), _truth(person=8)
    behind.parts[:] += shift
    both = _together(_truth(), behind)
    late = _exact() + shift
    late[:3] = np.nan
    one, other = judge(both, _tracked({1: _exact(), 2: late}), 20.0)
    assert (one.track, one.first_frame) == (1, 0)
    assert (other.track, other.first_frame) == (2, 3)


def test_a_part_that_is_off_for_a_while_is_wrong_then_and_breaks_the_strict_curve() -> None:
    table = _exact()
    table[8:12, 0] += 40.0
    rates = rates_of(judge(_truth(), _tracked({3: table}), 20.0), last=FRAMES - 1)
    assert rates.right[:, 0].tolist() == [1.0] * 8 + [0.0] * 4 + [1.0] * 18
    assert rates.unbroken[:, 0].tolist() == [1.0] * 8 + [0.0] * 22
    assert (rates.right[:, 1:3] == 1.0).all()


def test_judging_ends_where_somebody_leaves_the_picture() -> None:
    truth = _truth()
    truth.parts[20:, :, [0, 2]] += 150.0
    (one,) = judge(truth, _tracked({3: _exact()}), 20.0)
    assert len(one.parts) == 20


def test_who_is_hidden_from_the_beginning_is_not_judged() -> None:
    assert judge(_truth(visibility=0.5), _tracked({3: _exact()}), 20.0) == []


def test_a_run_s_rows_become_rectangles_round_their_centres() -> None:
    columns = {
        "frame": np.array([2, 2, 2]),
        "track": np.array([9, 9, 9]),
        "part": np.array([0, 1, 2]),
        "cx": np.array([50.0, 50, 50]),
        "cy": np.array([30.0, 65, 125]),
        "width": np.array([20.0, 30, 28]),
        "height": np.array([20.0, 50, 70]),
    }
    tracked = tracked_parts(columns)
    assert (tracked.frame.tolist(), tracked.track.tolist()) == ([2], [9])
    assert np.array_equal(tracked.parts[0], TRUE)
    assert tracked.person.tolist() == [[35.0, 20.0, 65.0, 160.0]]


def test_people_without_parts_are_judged_as_a_whole_only() -> None:
    still = {"left": 35.0, "top": 20.0, "width": 30.0, "height": 140.0}
    columns = {name: np.full(FRAMES, value) for name, value in still.items()}
    columns |= {"frame": np.arange(FRAMES), "track": np.full(FRAMES, 2)}
    (one,) = judge(_truth(), tracked_people(columns), 20.0)
    assert one.track == 2
    assert one.person_right.all()
    assert not one.parts.any()
    assert np.isnan(rates_of([one]).foreign).all()


def test_people_who_leave_no_longer_count() -> None:
    two = _together(_truth(), _truth(frames=10, person=8))
    rates = rates_of(judge(two, _tracked({3: _exact()}), 20.0), last=FRAMES + 5)
    assert rates.people.tolist() == [2] * 10 + [1] * 20 + [0] * 6


def test_margins_shrink_with_the_number_of_people() -> None:
    assert margin(0.9, 70) == pytest.approx(0.07, abs=0.01)
    assert margin(0.9, 700) < margin(0.9, 70)


def test_who_never_had_a_track_is_told_and_counts_in_every_rate() -> None:
    rates = rates_of(judge(_truth(), _tracked({}), 20.0))
    assert (rates.judged, rates.untracked) == (1, 1)
    assert rates.overall.tolist() == [0.0] * 4
    assert rates.as_text().endswith("no track began on 1 of them")


def test_the_table_has_rates_of_the_papers_frame_once_somebody_is_in_view_so_long() -> None:
    short = rates_of(judge(_truth(), _tracked({3: _exact()}), 20.0))
    assert short.as_text().splitlines()[1].split()[-1] == "1"
    assert "105 frames" not in short.as_text()
    steady = [
        replace(one, parts=np.ones((106, 3), bool), person_right=np.ones(106, bool))
        for one in judge(_truth(), _tracked({3: _exact()}), 20.0)
    ]
    assert "right after 105 frames    100.0 %" in rates_of(steady).as_text()


def test_curves_of_the_document_end_with_the_last_person_in_view() -> None:
    document = rates_of(judge(_truth(), _tracked({3: _exact()}), 20.0)).as_json()
    assert document["people_judged"] == 1
    assert document["people_from_start"] == [1] * FRAMES
    assert document["head"]["right_from_start"] == [1.0] * FRAMES
    assert document["person"] == {
        "right": 1.0,
        "right_from_start": [1.0] * FRAMES,
        "unbroken_from_start": [1.0] * FRAMES,
    }
    assert document["torso"]["foreign"] == 0.0


def test_nobody_to_judge_has_no_rates() -> None:
    document = rates_of([]).as_json()
    assert (document["people_judged"], document["people_from_start"]) == (0, [])
    assert document["head"]["right"] is None
    assert document["hip_leg"]["foreign"] is None
