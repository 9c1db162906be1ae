"""Where people come from and go to."""

from __future__ import annotations

import numpy as np
from linked_runs import FPS, VIEW, Stretch, id_near, ids_at, link_run, run_of, straight
from numpy.typing import NDArray

from tracking.trackers.linking.borders import birth_costs, death_costs
from tracking.trackers.linking.seen_rows import find_seen_rows, is_track_start
from tracking.trackers.linking.tracklets import cut_tracklets
from tracking.tracks import Run

FRAMES = 400
AWAY, BACK = straight((0, 6), (0, 9.5), 100), straight((0, 9.5), (0, 6), 100)
"""To where the upper edge cuts off heads, and still two metres from out of sight; and back."""
ASIDE = straight((0, 6), (2.5, 6), 100)
"""Two metres from the left and right edges all of a body is in the picture."""
HIDER = straight((2.4, 5.5), (2.4, 5.5), 140)


def costs(run: Run) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """What it costs that the people of a run, in order of their ids, come and go."""
    seen, _ = find_seen_rows(run, VIEW)
    pieces = cut_tracklets(seen, is_track_start(seen).astype(np.uint8), FPS)
    start, stop = run.frames
    return (
        birth_costs(seen, pieces, run.tracks, VIEW, FPS, start),
        death_costs(seen, pieces, run.tracks, VIEW, FPS, stop),
    )


def test_who_is_cut_off_above_and_far_from_out_of_sight_hardly_comes_or_goes_there() -> None:
    out = straight((0, 9), (0, 12), 100)
    within = run_of(Stretch(1, 50, AWAY), Stretch(2, 150, BACK), frames=FRAMES)
    at_edge = run_of(Stretch(1, 50, out), Stretch(2, 150, out[::-1]), frames=FRAMES)
    born, gone = costs(within)
    born_at_edge, gone_at_edge = costs(at_edge)
    assert gone[0] > gone_at_edge[0] + 2.0
    assert born[1] > born_at_edge[1] + 2.0


def test_behind_somebody_people_come_and_go_rather_than_in_the_open() -> None:
    alone = run_of(Stretch(1, 50, ASIDE), Stretch(2, 200, ASIDE[::-1]), frames=FRAMES)
    covered = run_of(
        Stretch(1, 50, ASIDE),
        Stretch(2, 200, ASIDE[::-1]),
        Stretch(3, 100, HIDER),
        frames=FRAMES,
    )
    (born, gone), (born_behind, gone_behind) = costs(alone), costs(covered)
    assert gone_behind[0] < gone[0] - 1.0
    assert born_behind[1] < born[1] - 1.0


def test_who_is_lost_where_heads_are_cut_off_and_found_there_a_second_later_is_one_person() -> None:
    run = link_run(run_of(Stretch(1, 50, AWAY), Stretch(2, 170, BACK), frames=FRAMES), VIEW, FPS)
    assert id_near(run, 60, AWAY[10]) == id_near(run, 260, BACK[90]) == 1


def test_an_id_given_again_long_after_somebody_left_is_of_somebody_new() -> None:
    gone = straight((0, 6), (4.5, 6), 100)
    run = run_of(Stretch(1, 0, gone), Stretch(1, 260, gone[::-1]), frames=FRAMES)
    assert set(ids_at(link_run(run, VIEW, FPS), 10)) == {1}
    assert set(ids_at(link_run(run, VIEW, FPS), 330)) == {2}
