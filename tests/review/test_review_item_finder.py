"""Looking again after an edit finds what looking through everything finds."""

from __future__ import annotations

import numpy as np
import pytest
from walks_on_a_floor import BLUE, FPS, RED, SIZE, Walk, made_run, straight

from tracking.editing import apply_change, plan_delete, plan_merge_tracks, plan_split, plan_swap
from tracking.errors import CancelledError
from tracking.review import ReviewItemFinder, find_review_items, review_search
from tracking.review.footage import Footage
from tracking.tracks import Labels, Occluder, Run, TrackTable

FRAMES = 3000


def long_run() -> Run:
    """Two and a half minutes: people who wander, meet, hide for long, come and go."""
    random = np.random.default_rng(3102)
    walks = []
    for number in range(12):
        start = int(random.integers(0, FRAMES - 900))
        length = int(random.integers(600, FRAMES - start + 1))
        turned = np.cumsum(random.normal(0.0, 0.08, length)) + random.uniform(0, 6)
        path = np.cumsum(np.stack((np.cos(turned), np.sin(turned)), axis=1) / FPS, axis=0)
        path = np.abs((path + random.uniform(0, 8, 2)) % 8 - 4)
        hidden = np.concatenate([np.arange(60) + at for at in random.integers(0, FRAMES, 4)])
        looks = (RED, BLUE)[number % 2]
        walks.append(Walk(path, start=start, looks=looks, predicted=hidden))
    walks.append(
        Walk(straight((3, 9), (0, 0), FRAMES), looks=RED, predicted=range(200, FRAMES - 150))
    )
    return made_run(walks)


RUN = long_run()


def look(lookout: ReviewItemFinder, table: TrackTable, **more: object) -> tuple[object, ...]:
    return lookout.find(table.snapshot(), RUN, FPS, size=SIZE, with_begun=False, **more).items


def whole(table: TrackTable, **more: object) -> tuple[object, ...]:
    return find_review_items(table, RUN, FPS, size=SIZE, **more)


@pytest.fixture
def in_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Blocks as short as those of long footage, though few people are here."""
    monkeypatch.setattr(Footage, "length", lambda *_: 300)


@pytest.mark.usefixtures("in_blocks")
def test_after_each_edit_it_finds_what_looking_through_everything_finds() -> None:
    table, lookout = TrackTable(RUN.tracks), ReviewItemFinder()
    assert look(lookout, table) == whole(table)
    one, other, third = 1, 2, 4
    together = [table.frame_range(track) for track in (one, other)]
    start, end = max(s for s, _ in together), min(e for _, e in together)
    random = np.random.default_rng(3103)
    frames = [int(frame) for frame in random.integers(start + 50, end - 50, 3)]
    for frame in frames:
        apply_change(table, Labels(), plan_swap(table, one, other, frame))
        assert look(lookout, table) == whole(table)
    begin, stop = table.frame_range(third)
    for plan in (
        lambda: plan_split(table, third, (begin + stop) // 2),
        lambda: plan_merge_tracks(table, third, [table.highest_track]),
        lambda: plan_delete(table, third, stop - 200),
    ):
        apply_change(table, Labels(), plan())
        assert look(lookout, table) == whole(table)


@pytest.mark.usefixtures("in_blocks")
def test_it_does_not_matter_where_blocks_begin(monkeypatch: pytest.MonkeyPatch) -> None:
    table = TrackTable(RUN.tracks)
    cut = {(one.kind, one.tracks, one.frame): one for one in whole(table)}
    monkeypatch.setattr(Footage, "length", lambda *_: FRAMES)
    uncut = {(one.kind, one.tracks, one.frame): one for one in whole(table)}
    assert len(uncut) > 50
    assert len(cut.keys() ^ uncut.keys()) <= 0.02 * len(uncut)
    same = [cut[key] == uncut[key] for key in cut.keys() & uncut.keys()]
    assert np.mean(same) > 0.98


@pytest.mark.usefixtures("in_blocks")
def test_an_edit_leaves_blocks_far_from_it_as_they_were(monkeypatch: pytest.MonkeyPatch) -> None:
    looked: list[int] = []
    through = review_search.search_block

    def counted(*words: object) -> object:
        looked.append(1)
        return through(*words)

    monkeypatch.setattr(review_search, "search_block", counted)
    table, lookout = TrackTable(RUN.tracks), ReviewItemFinder()
    look(lookout, table)
    assert len(looked) == FRAMES / 300
    look(lookout, table)
    assert len(looked) == FRAMES / 300
    track = next(track for track in table.track_ids if table.frame_range(track)[1] > FRAMES - 400)
    end = table.frame_range(track)[1]
    apply_change(table, Labels(), plan_delete(table, track, end - 20))
    look(lookout, table)
    assert len(looked) <= FRAMES / 300 + 3


@pytest.mark.usefixtures("in_blocks")
def test_other_labels_another_run_and_a_cancelled_search_are_told_apart() -> None:
    table, lookout = TrackTable(RUN.tracks), ReviewItemFinder()
    pillar = Occluder("pillar", ((280.0, 100.0), (360.0, 100.0), (360.0, 400.0), (280.0, 400.0)))
    hides = Labels(occluders=(pillar,))

    def stop(done: int, total: int) -> None:
        if done == 4:
            raise CancelledError("enough")

    with pytest.raises(CancelledError):
        look(lookout, table, progress=stop)
    assert look(lookout, table) == whole(table)
    assert look(lookout, table, labels=hides) == whole(table, labels=hides)
    assert whole(table, labels=hides) != whole(table)
    assert lookout.find(table, None, FPS).items == find_review_items(table, None, FPS)


@pytest.mark.usefixtures("in_blocks")
def test_who_is_out_of_sight_for_longer_than_a_block_is_told_for_how_long() -> None:
    told = [one.text for one in whole(TrackTable(RUN.tracks)) if one.tracks == (13,)]
    seconds = (FRAMES - 150 - 200) / FPS
    assert any(f"out of sight for {seconds:.1f} s" in text for text in told)
