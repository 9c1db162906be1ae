"""What the benchmark of spheroids says of tracks whose faults are known."""

from __future__ import annotations

import numpy as np
import pytest

from tests.benchmarks.clips import Columns
from tests.benchmarks.spheroid.__main__ import PAGE, added, verdict
from tests.benchmarks.spheroid.measures import Followed, errors_cm, follow, ghosts_s, mix_ups


def _columns(rows: list[tuple[int, int, float, float]]) -> Columns:
    table = np.array(rows, float).reshape(-1, 4)
    return {
        "frame": table[:, 0].astype(np.int64),
        "track": table[:, 1].astype(np.int64),
        "x": table[:, 2],
        "y": table[:, 3],
    }


def _two_who_pass(ids: tuple[list[int], list[int]]) -> Followed:
    """Two people 2 m apart for six frames, followed by these ids, 0 for nobody."""
    truth = [(frame, person, 0.0, 2.0 * person) for frame in range(6) for person in (1, 2)]
    tracks = [
        (frame, own[frame], 0.0, 2.0 * person)
        for frame in range(6)
        for person, own in zip((1, 2), ids, strict=True)
        if own[frame]
    ]
    return follow(_columns(truth), _columns(tracks), 0.7)


def test_people_who_keep_their_tracks_are_neither_swapped_nor_lost() -> None:
    assert mix_ups(_two_who_pass(([1] * 6, [2] * 6))) == {"swapped": 0, "renamed": 0, "missed": 0}


def test_two_tracks_that_change_places_are_two_swapped() -> None:
    followed = _two_who_pass(([1, 1, 1, 2, 2, 2], [2, 2, 2, 1, 1, 1]))
    assert mix_ups(followed) == {"swapped": 2, "renamed": 0, "missed": 0}


def test_who_is_lost_and_found_again_is_renamed() -> None:
    followed = _two_who_pass(([1, 1, 0, 0, 7, 7], [2] * 6))
    assert mix_ups(followed) == {"swapped": 0, "renamed": 1, "missed": 0}


def test_who_is_hardly_followed_is_missed() -> None:
    frames = 20
    truth = [(frame, 1, 0.0, 0.0) for frame in range(frames)]
    tracks = [(frame, 1, 0.1, 0.0) for frame in range(8)]
    assert mix_ups(follow(_columns(truth), _columns(tracks), 0.7))["missed"] == 1


def test_the_error_is_the_distance_on_the_floor_and_nothing_where_nobody_follows() -> None:
    truth = [(frame, 3, 1.0, 1.0) for frame in range(4)]
    tracks = [(0, 1, 1.03, 1.04), (1, 1, 1.0, 1.1), (2, 1, 3.0, 3.0)]
    followed = follow(_columns(truth), _columns(tracks), 0.6)
    assert followed.error_m == pytest.approx([0.05, 0.1, np.nan, np.nan], nan_ok=True)
    said = errors_cm([followed.during(0, 4, 3)])
    assert said["mean_cm"] == pytest.approx(7.5)
    assert said["std_cm"] == pytest.approx(2.5)
    assert said["followed"] == 0.5
    assert len(followed.during(1, 2, 3).frame) == 1
    assert len(followed.during(0, 4, 5).frame) == 0


def test_a_track_is_a_ghost_while_nobody_is_near_it() -> None:
    truth = [(frame, 1, 0.0, 0.0) for frame in range(10)]
    tracks = [(frame, 1, 0.2, 0.0) for frame in range(10)]
    tracks += [(frame, 2, 0.2 if frame < 4 else 5.0, 0.5) for frame in range(20)]
    stays = sorted(_columns(sorted(tracks))["frame"].tolist())
    assert len(stays) == 30
    seconds = ghosts_s(_columns(truth), _columns(sorted(tracks)), fps=2.0)
    assert seconds == pytest.approx([0.0, 8.0])


def test_a_gap_ends_a_ghost_s_stretch() -> None:
    tracks = [(frame, 1, 5.0, 0.0) for frame in (0, 1, 2, 6, 7)]
    assert ghosts_s(_columns([]), _columns(tracks), fps=1.0) == pytest.approx([3.0])


def test_a_small_error_of_few_frames_meets_no_goal() -> None:
    row = {"mean_cm": 4.2, "followed": 0.98}
    assert verdict(row, 5) == "met"
    assert verdict(row, 4) == "missed by 0.2"
    assert verdict({**row, "followed": 0.6}, 5) == "missed: people are lost"
    assert verdict({"mean_cm": None, "followed": 0.0}, 5) == "missed"


def test_situations_of_several_seeds_are_added_and_easy_swaps_are_told() -> None:
    row = {"scene": "situation-2", "title": "cross", "people": 2, "renamed": 0, "missed": 0}
    rows = [{**row, "difficulty": 2, "swapped": swapped} for swapped in (0, 2)]
    assert [(one["people"], one["swapped"]) for one in added(rows)] == [(4, 2)]
    page = PAGE.sections({"situations": rows})["situations"]
    assert "rated up to 3: 2 tracks swapped there" in page
    assert "nobody swapped there" in PAGE.sections({"situations": rows[:1]})["situations"]
