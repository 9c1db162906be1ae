"""What a review item proposes puts it right: done at its frame, the reason is gone."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from walks_on_a_floor import (
    BLUE,
    FPS,
    RED,
    SIZE,
    Walk,
    crossing,
    made_run,
    straight,
    swapped,
    with_column,
)

from tracking.editing import (
    Change,
    apply_change,
    plan_delete,
    plan_merge_tracks,
    plan_split,
    plan_swap,
)
from tracking.review import find_review_items
from tracking.review.core.evidence import gather_evidence
from tracking.review.core.findings import FlaggedPlaces
from tracking.review.core.material import Material
from tracking.review.reason_phrases import fix
from tracking.review.reasons import REASONS
from tracking.tracks import Labels, Run, TrackTable

AT = 80
Scene = tuple[Run, TrackTable]


def exchanged() -> Scene:
    run = made_run(crossing())
    return run, swapped(run, 1, 2, AT)


def turned() -> Scene:
    run = made_run([Walk(walk.path) for walk in crossing()])
    return run, swapped(run, 1, 2, AT)


def one_track(path: np.ndarray, **more: object) -> Scene:
    run = made_run([Walk(path, **more)])
    return run, TrackTable(run.tracks)


def coloured() -> Scene:
    run, _ = one_track(straight((-3, 5), (0.5, 0), 160), looks=RED)
    for name, value in zip(("upper_a", "upper_b", "lower_l"), BLUE[2:5], strict=True):
        with_column(run, "signals", name, run.signals["frame"] >= AT, value)
    return run, TrackTable(run.tracks)


def grown() -> Scene:
    run, _ = one_track(straight((-3, 5), (0.5, 0), 160), looks=RED)
    with_column(run, "signals", "height_m", run.signals["frame"] >= AT, 1.3)
    return run, TrackTable(run.tracks)


def jumped(speed: float = 2.5, frames: int = 1) -> Scene:
    """Somebody fast who is elsewhere within so many frames."""
    path = straight((-4, 5), (speed, 0), 160)
    path[:, 1] += np.clip((np.arange(160) - AT + 1) / frames, 0.0, 1.0)
    return one_track(path)


def turned_back() -> Scene:
    path = straight((-3, 5), (1.2, 0), 160)
    path[AT:] = path[AT] - (path[AT:] - path[AT])
    return one_track(path, predicted=range(AT - 4, AT + 4))


def unseen_for_long() -> Scene:
    return one_track(straight((-3, 5), (0.5, 0), 160), predicted=range(AT - 50, AT))


def drifting() -> Scene:
    return one_track(straight((-3, 5), (0.5, 0), 160), predicted=range(AT, 160))


def torn() -> Scene:
    path = straight((-3, 5), (1, 0), 160)
    run = made_run([Walk(path[:70], looks=RED), Walk(path[AT:], start=AT, looks=RED)])
    return run, TrackTable(run.tracks)


SCENES: dict[str, Callable[[], Scene]] = {
    "exchange": exchanged,
    "turn": turned,
    "colour": coloured,
    "height": grown,
    "jump": jumped,
    "reversal": turned_back,
    "predicted": unseen_for_long,
    "drift": drifting,
    "lost": torn,
}
"""One for each kind whose fix takes its cause away. "crossing", "shared" and "margin" tell of what
happened, whoever is who: they go by a verdict."""


def looked(kind: str, run: Run, table: TrackTable) -> FlaggedPlaces:
    return REASONS[kind](Material.of(gather_evidence(table, run, FPS), SIZE, ()))


def proposed(kind: str, table: TrackTable, first: int, second: int, frame: int) -> Change:
    """The edit that a review item of the kind proposes."""
    plans: dict[str, Callable[[], Change]] = {
        "swap": lambda: plan_swap(table, first, second, frame),
        "split": lambda: plan_split(table, first, frame),
        "merge": lambda: plan_merge_tracks(table, first, [second]),
        "delete": lambda: plan_delete(table, first, frame),
    }
    return plans[fix(kind, second)]()


@pytest.mark.parametrize("kind", SCENES)
def test_the_proposed_fix_takes_the_reason_away(kind: str) -> None:
    run, table = SCENES[kind]()
    seen = looked(kind, run, table)
    assert len(seen) == 1
    place = (int(seen.first[0]), int(seen.second[0]), int(seen.frame[0]))
    apply_change(table, Labels(), proposed(kind, table, *place))
    assert len(looked(kind, run, table)) == 0


@pytest.mark.parametrize("speed", [0.5, 2.5, 5.0])
@pytest.mark.parametrize("frames", [1, 2])
def test_a_jump_is_told_in_the_first_frame_after_it(speed: float, frames: int) -> None:
    run, table = jumped(speed, frames)
    frame = int(looked("jump", run, table).frame[0])
    assert frame in range(AT, AT + frames)
    apply_change(table, Labels(), plan_split(table, 1, frame))
    assert len(looked("jump", run, table)) == 0


def test_a_swap_put_right_where_it_is_told_leaves_what_there_would_be_without() -> None:
    run, table = exchanged()
    first = find_review_items(table, run, FPS, size=SIZE)[0]
    apply_change(table, Labels(), plan_swap(table, *first.tracks, first.frame))
    right = find_review_items(TrackTable(run.tracks), run, FPS, size=SIZE)
    assert find_review_items(table, run, FPS, size=SIZE) == right
