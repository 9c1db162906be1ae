"""Review items: found where tracks are wrong, said in words, joined, ranked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from walks_on_a_floor import BLUE, FPS, RED, SIZE, Walk, crossing, made_run, straight, swapped

from tracking.editing import apply_change, plan_reassign, plan_swap
from tracking.errors import CancelledError
from tracking.review import KINDS, ReviewItem, find_review_items
from tracking.review.reason_phrases import clock, sentence
from tracking.tracks import Labels, Occluder, Run, TrackTable

MEETING = 80


def found(run: Run, table: TrackTable | None = None, **more: object) -> tuple[ReviewItem, ...]:
    tracks = TrackTable(run.tracks) if table is None else table
    return find_review_items(tracks, run, FPS, size=SIZE, **more)


def test_two_tracks_that_changed_over_are_looked_at_first() -> None:
    run = made_run(crossing())
    first = found(run, swapped(run, 1, 2, MEETING))[0]
    assert (first.tracks, first.fix) == ((1, 2), "swap")
    assert first.start <= MEETING < first.end
    assert first.likelihood > 0.9


def test_people_who_only_cross_are_far_less_likely_flagged() -> None:
    run = made_run(crossing())
    right = max(one.likelihood for one in found(run))
    wrong = found(run, swapped(run, 1, 2, MEETING))[0].likelihood
    assert right < 0.2 < 0.9 < wrong


def test_a_mistake_is_one_review_item_with_all_its_reasons() -> None:
    run = made_run(crossing())
    both = [one for one in found(run, swapped(run, 1, 2, MEETING)) if one.likelihood > 0.3]
    assert len(both) == 1
    said = [both[0].text, *both[0].others]
    assert any("colours swapped" in each for each in said)
    assert any("passed within 0." in each for each in said)
    assert all("00:04" in each or "00:03" in each for each in said)


def test_a_swap_put_right_is_flagged_no_more() -> None:
    run = made_run(crossing())
    table = swapped(run, 1, 2, MEETING)
    again = swapped_back(table)
    assert found(run, again) == found(run)


def swapped_back(table: TrackTable) -> TrackTable:
    apply_change(table, Labels(), plan_swap(table, 1, 2, MEETING))
    return table


def test_what_the_run_noticed_moves_with_the_rows_of_an_edit() -> None:
    """Rows that an edit gave another track still have their colours, or all would look changed."""
    walks = [Walk(straight((-2, 5), (0.1, 0), 100), looks=RED), *crossing(100)]
    run = made_run(walks)
    table = TrackTable(run.tracks)
    apply_change(table, Labels(), plan_reassign(table, 1, 9, 0))
    assert {one.tracks for one in found(run, table)} == {
        tuple(9 if track == 1 else track for track in one.tracks) for one in found(run)
    }


def test_review_items_are_ranked_by_what_they_are_worth() -> None:
    run = made_run([*crossing(), Walk(straight((3, 5), (0, 0.2), 60), start=20, looks=BLUE)])
    worth = [one.likelihood * one.cost for one in found(run, swapped(run, 1, 2, MEETING))]
    assert len(worth) > 1
    assert worth == sorted(worth, reverse=True)


def test_every_review_item_says_why_what_to_do_and_what_to_watch() -> None:
    run = made_run([*crossing(), Walk(straight((0.5, 6), (0, 0), 50), start=60)])
    items = found(run, swapped(run, 1, 2, MEETING))
    assert items
    for one in items:
        assert one.kind in KINDS
        assert one.text
        assert "{" not in one.text
        assert one.fix in ("swap", "split", "merge", "delete", "look")
        assert 0 <= one.start <= one.frame < one.end <= run.frames[1]
        assert 0.0 <= one.likelihood <= 1.0
        assert one.tracks == tuple(sorted(set(one.tracks)))


def test_the_same_tracks_give_the_same_review_items() -> None:
    run = made_run(crossing())
    table = swapped(run, 1, 2, MEETING)
    assert found(run, table) == found(run, table.snapshot())


def test_runs_that_noticed_nothing_are_looked_through_all_the_same() -> None:
    run = made_run(crossing())
    table = swapped(run, 1, 2, MEETING)
    alone = find_review_items(table, None, FPS)
    assert alone[0].tracks == (1, 2)
    assert not {"exchange", "colour", "height", "spread", "split"} & {one.kind for one in alone}


def test_tracks_without_a_floor_are_measured_by_their_boxes() -> None:
    run = made_run(crossing())
    px = 120 / 1.7
    columns = dict(run.tracks)
    columns["left"] = 320 + columns["x"] * px
    columns["top"] = columns["y"] * px - 300
    columns["x"] = columns["y"] = np.full(len(columns["x"]), np.nan)
    table = TrackTable(columns)
    apply_change(table, Labels(), plan_swap(table, 1, 2, MEETING))
    first = find_review_items(table, None, FPS)[0]
    assert first.tracks == (1, 2)
    assert first.start <= MEETING < first.end


def test_a_track_that_another_goes_on_from_should_be_merged() -> None:
    path = straight((-3, 5), (1, 0), 160)
    run = made_run([Walk(path[:70], looks=RED), Walk(path[80:], start=80, looks=RED)])
    first = found(run)[0]
    assert (first.kind, first.fix, first.tracks) == ("lost", "merge", (1, 2))
    assert first.start <= 80 < first.end


def test_ends_at_the_border_and_at_occluders_are_no_riddle() -> None:
    path = straight((-3, 5), (1, 0), 160)

    def kinds(box: tuple[float, float], labels: Labels | None = None) -> set[str]:
        walks = [Walk(path[:70], box=box), Walk(path[80:], start=80, box=box)]
        return {one.kind for one in found(made_run(walks), labels=labels)}

    assert "lost" in kinds((300, 200))
    assert "lost" not in kinds((2, 200))
    pillar = Occluder("pillar", ((280.0, 100.0), (360.0, 100.0), (360.0, 400.0), (280.0, 400.0)))
    assert "lost" not in kinds((300, 200), Labels(occluders=(pillar,)))


def test_nothing_is_flagged_where_nobody_is() -> None:
    assert find_review_items(TrackTable(), None, FPS) == ()


def test_one_person_walking_straight_is_not_flagged() -> None:
    assert found(made_run([Walk(straight((-3, 5), (1, 0), 120))])) == ()


def test_the_search_tells_how_far_it_is_and_can_be_cancelled() -> None:
    told: list[tuple[int, int]] = []
    found(made_run(crossing()), progress=lambda done, total: told.append((done, total)))
    assert told == sorted(told)
    assert told[-1][0] == told[-1][1]

    def stop(done: int, total: int) -> None:
        raise CancelledError("enough")

    with pytest.raises(CancelledError, match="enough"):
        found(made_run(crossing()), progress=stop)


def test_who_changed_over_is_watched_until_they_part() -> None:
    """Two who walk side by side for a while show who is who only then."""

    def stretch(side_by_side: int) -> int:
        one = straight((-4, 5), (1.0, 0.0), 160)
        other = one + np.array((0.0, 0.3))
        away = MEETING + side_by_side
        other[away:, 1] += np.arange(160 - away) * 0.08
        run = made_run([Walk(one, looks=RED), Walk(other, looks=BLUE)])
        told = found(run, swapped(run, 1, 2, MEETING))
        first = next(each for each in told if each.kind in ("turn", "exchange"))
        return first.end - first.frame

    assert stretch(0) < stretch(10) < stretch(15) <= 0.95 * FPS + 1
    assert stretch(60) == stretch(40)


def test_people_swapped_across_the_floor_are_told_where_they_were() -> None:
    """Farther apart than anybody is mistaken, but by hand: both leap in the very same frame."""
    apart = [
        Walk(straight((-4, 5), (1, 0), 160), looks=RED),
        Walk(straight((-4, 8), (1, 0), 160), looks=BLUE),
    ]
    run = made_run(apart)
    assert not found(run)
    first = found(run, swapped(run, 1, 2, MEETING))[0]
    assert (first.kind, first.tracks, first.frame) == ("turn", (1, 2), MEETING)
    assert first.start <= MEETING < first.end
    assert first.likelihood > 0.5


def test_where_no_floor_is_known_nothing_is_said_in_metres() -> None:
    run = made_run(crossing())
    tracks = {name: column.copy() for name, column in run.tracks.items()}
    for name in ("x", "y"):
        tracks[name][:] = np.nan
    nowhere = replace(run, tracks=tracks)
    said = [text for one in found(nowhere) for text in (one.text, *one.others)]
    assert any("body heights" in text for text in said)
    assert not any(" m " in text or "floor" in text for text in said)


def test_ways_are_said_in_body_heights_where_the_floor_is_not_known() -> None:
    within = sentence("crossing", 1, 5, 0.85, 4.0, on_floor=False)
    assert within == "1 and 5 passed within 0.5 body heights at 00:04.00"
    begun = sentence("begun", 4, 0, 0.0, 4.0, on_floor=False)
    assert begun == "4 begins in the middle of the image at 00:04.00"


def test_a_review_item_names_the_second_its_frame_lies_in() -> None:
    run = made_run(crossing())
    told = [one for one in found(run, swapped(run, 1, 2, MEETING)) if " 00:" in one.text]
    assert told
    assert all(clock(one.frame / FPS) in one.text for one in told)
