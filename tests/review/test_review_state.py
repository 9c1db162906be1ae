"""How far a review is: the same for whoever asks, and no more errors after one is put right."""

from __future__ import annotations

import numpy as np
import pytest
from walks_on_a_floor import FPS, SIZE, Walk, made_run, straight

from tracking.editing import (
    apply_change,
    plan_delete,
    plan_merge_tracks,
    plan_put_box,
    plan_split,
    plan_swap,
)
from tracking.review import ReviewFinding, ReviewItem, ReviewItemFinder, review_state
from tracking.review.risk import DecidedItems, errors_left, learned_rate
from tracking.review.seams import corrected_items, seams
from tracking.tracks import Labels, Run, TrackTable, Verdict, row_keys

MEETING = 50


@pytest.fixture(scope="module")
def run() -> Run:
    """Two people who cross over; a third one is away for a while, and has two tracks."""
    away = straight((-3, 9), (1, 0), 100)
    return made_run(
        [
            Walk(straight((-3, 5), (1, 0), 100)),
            Walk(straight((-3, 7), (1, 0), 100)),
            Walk(away[:40]),
            Walk(away[60:], start=60),
        ]
    )


def item(kind: str, tracks: tuple[int, ...], frame: int, likelihood: float = 0.4) -> ReviewItem:
    return ReviewItem(kind, tracks, frame, frame - 5, frame + 5, likelihood, 9.0, kind, "swap")


def verdicts(*decided: tuple[ReviewItem, str]) -> Labels:
    every = [Verdict(one.kind, one.tracks, one.frame, decision) for one, decision in decided]
    return Labels(verdicts={one.key: one for one in every})


def edited(run: Run, plan: object) -> TrackTable:
    table = TrackTable(run.tracks)
    apply_change(table, Labels(), plan(table))
    return table


def test_what_was_put_right_counts_as_decided_with_what_was_stated_of_it(run: Run) -> None:
    table = TrackTable(run.tracks)
    first, other = item("turn", (1, 2), 50, 0.3), item("lost", (3, 4), 60, 0.2)
    labels = verdicts((first, "fixed"))
    state = review_state(ReviewFinding((other,), (first, other)), labels, table, FPS)
    assert (state.decided, state.items, state.found) == (1, 2, (other,))
    assert (state.outcome.stated, state.outcome.errors) == (0.3, 1)
    assert state.reviewed == pytest.approx(20 / len(table))  # both people, ten frames
    left = errors_left(0.2, DecidedItems(0.3, 1), 0.5 * (1 - state.reviewed))
    assert state.errors == left
    assert 0 < left.at_items < left.mean
    assert state.minutes_left == pytest.approx(10 / FPS / 60)


def test_of_an_item_that_only_an_edit_brought_about_the_usual_is_stated(run: Run) -> None:
    table = TrackTable(run.tracks)
    there = (item("turn", (1, 2), 20, 0.2), item("turn", (1, 2), 80, 0.4))
    labels = verdicts((item("turn", (3, 4), 50), "fixed"), (item("begun", (4,), 60), "right"))
    state = review_state(ReviewFinding(there, there), labels, table, FPS)
    assert state.outcome.stated == pytest.approx(0.3 + 0.5)
    assert review_state(ReviewFinding(), Labels(), TrackTable(), FPS).items == 0


def test_a_verdict_stays_with_what_is_found_a_little_beside(run: Run) -> None:
    table = TrackTable(run.tracks)
    was, now = item("turn", (1, 2), 50, 0.1), item("turn", (1, 2), 51, 0.9)
    state = review_state(ReviewFinding((now,), (was,)), verdicts((was, "fixed")), table, FPS)
    assert (state.decided, state.left) == (1, ())
    assert state.outcome.stated == 0.1


def test_no_error_is_expected_where_the_tracks_were_corrected_but_it_can_be_looked_at(
    run: Run,
) -> None:
    table = TrackTable(run.tracks)
    one, other = item("turn", (1, 2), 50), item("turn", (1, 2), 90)
    both = review_state(ReviewFinding((one, other)), Labels(), table, FPS)
    finding = ReviewFinding((one, other), corrected=frozenset({one.key}))
    state = review_state(finding, Labels(), table, FPS)
    assert state.left == both.left
    assert state.errors.mean == pytest.approx(both.errors.mean / 2)


def test_a_swap_that_is_put_right_by_hand_lets_expect_fewer_errors(run: Run) -> None:
    wrong = edited(run, lambda table: plan_swap(table, 1, 2, MEETING))
    columns = {name: wrong.columns()[name] for name in run.tracks}
    tracked = made_of(run, columns)
    table, finder = TrackTable(tracked.tracks), ReviewItemFinder()

    def expected() -> float:
        finding = finder.find(table, tracked, FPS, size=SIZE)
        return review_state(finding, Labels(), table, FPS).errors.mean

    before = expected()
    apply_change(table, Labels(), plan_swap(table, 1, 2, MEETING))
    after = expected()
    assert after < before
    # Exchanged once more in vain, what is seen there is that edit: no error of the tracker's.
    apply_change(table, Labels(), plan_swap(table, 1, 2, MEETING - 20))
    assert expected() <= before


def made_of(run: Run, tracks: dict[str, np.ndarray]) -> Run:
    order = np.lexsort((tracks["track"], tracks["frame"]))
    given = {name: getattr(run, name) for name in ("tracker", "settings", "seed", "frames")}
    kept = {name: column[order] for name, column in tracks.items()}
    return Run(**given, tracks=kept, detections=run.detections, particles=run.particles)


def test_tracks_as_they_began_have_no_seam(run: Run) -> None:
    begun = TrackTable(run.tracks)
    assert not len(seams(begun, TrackTable(run.tracks)))
    moved = edited(run, lambda table: plan_put_box(table, 1, 50, (1.0, 2.0, 9.0, 9.0)))
    assert not len(seams(begun, moved))
    assert not len(seams(TrackTable(), TrackTable()))


@pytest.mark.parametrize(
    ("plan", "expected"),
    [
        (lambda t: plan_swap(t, 1, 2, 50), [(1, 49), (1, 50), (2, 49), (2, 50)]),
        (lambda t: plan_swap(t, 1, 2, 50, 60), [(t, f) for t in (1, 2) for f in (49, 50, 59, 60)]),
        (lambda t: plan_split(t, 1, 50), [(1, 49), (5, 50)]),
        (lambda t: plan_merge_tracks(t, 3, (4,)), [(3, 39), (3, 60)]),
        (lambda t: plan_delete(t, 1, 50), [(1, 49)]),
    ],
    ids=["swap", "range", "split", "merge", "delete"],
)
def test_seams_are_where_an_edit_cut_or_joined(run: Run, plan: object, expected: list) -> None:
    found = seams(TrackTable(run.tracks), edited(run, plan))
    tracks, frames = np.array(expected).T
    assert found.tolist() == sorted(row_keys(tracks, frames).tolist())


def test_an_item_shows_a_seam_of_its_own_people_alone(run: Run) -> None:
    swapped = edited(run, lambda table: plan_swap(table, 1, 2, 50))
    items = (
        *(item("turn", (1, 2), 50), item("lost", (2, 4), 53), item("turn", (1, 2), 57)),
        item("jump", (3,), 50),
    )
    there = corrected_items(items, TrackTable(run.tracks), swapped)
    assert there == {items[0].key, items[1].key}


def test_decisions_say_how_many_times_as_many_errors_there_are() -> None:
    assert learned_rate(DecidedItems()) == 1.0
    assert learned_rate(DecidedItems(0.1, 1)) > 1.25
    assert learned_rate(DecidedItems(5.0, 0)) < 0.8


def test_after_a_search_that_was_cancelled_nothing_of_another_run_is_left(run: Run) -> None:
    other = made_run([Walk(straight((-3, 5), (1, 0), 100)), Walk(straight((-3, 9), (1, 0), 60))])
    finder = ReviewItemFinder()
    finder.find(TrackTable(run.tracks), run, FPS, size=SIZE)

    def cancel(*_: int) -> None:
        raise KeyboardInterrupt

    table = TrackTable(other.tracks)
    with pytest.raises(KeyboardInterrupt):
        finder.find(table, other, FPS, progress=cancel, size=SIZE)
    found = finder.find(table, other, FPS, size=SIZE)
    assert found == ReviewItemFinder().find(table, other, FPS, size=SIZE)
    assert found.begun != finder.find(TrackTable(run.tracks), run, FPS, size=SIZE).begun
