"""Each reason finds what it is for, and nothing in people who just walk."""

from __future__ import annotations

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

from app.core.i18n import time_text
from tracking.review.core.evidence import gather_evidence
from tracking.review.core.findings import FlaggedPlaces
from tracking.review.core.material import Material
from tracking.review.reason_phrases import WORDS, sentence
from tracking.review.reasons import REASONS
from tracking.tracks import PART_COLUMNS, Run, TrackTable
from tracking.translation import tr


def found(kind: str, run: Run, table: TrackTable | None = None) -> FlaggedPlaces:
    tracks = TrackTable(run.tracks) if table is None else table
    return REASONS[kind](Material.of(gather_evidence(tracks, run, FPS), SIZE, ()))


def apart() -> list[Walk]:
    """Two people side by side, two metres from each other."""
    return [Walk(straight((x, 4), (0, 0.8), 120)) for x in (-1.0, 1.0)]


@pytest.mark.parametrize("kind", [kind for kind in REASONS if kind not in ("begun", "ended")])
def test_people_who_just_walk_give_no_reason(kind: str) -> None:
    assert len(found(kind, made_run(apart()))) == 0


def test_trails_within_half_a_metre_cross() -> None:
    seen = found("crossing", made_run(crossing()))
    assert (seen.first.tolist(), seen.second.tolist()) == ([1], [2])
    assert abs(int(seen.frame[0]) - 80) <= 3
    assert seen.figure[0] == pytest.approx(0.14, abs=0.04)


def test_looks_that_changed_over_are_told_near_the_swap() -> None:
    run = made_run(crossing())
    seen = found("exchange", run, swapped(run, 1, 2, 80))
    assert len(seen) == 1
    assert abs(int(seen.frame[0]) - 80) <= 4
    assert seen.strength[0] == 1.0
    assert len(found("exchange", run)) == 0


def test_people_dressed_alike_change_over_unseen() -> None:
    run = made_run([Walk(walk.path) for walk in crossing()])
    assert len(found("exchange", run, swapped(run, 1, 2, 80))) == 0


def test_walks_that_go_on_as_the_others_are_told_to_the_frame() -> None:
    run = made_run(crossing())
    assert found("turn", run, swapped(run, 1, 2, 83)).frame.tolist() == [83]


def test_colours_that_change_inside_a_track_are_told() -> None:
    run = made_run([Walk(straight((-3, 5), (0.5, 0), 160), looks=RED)])
    for name, value in zip(("upper_a", "upper_b", "lower_l"), (-40, -30, 90), strict=True):
        with_column(run, "signals", name, run.signals["frame"] >= 90, value)
    seen = found("colour", run)
    assert len(seen) == 1
    assert abs(int(seen.frame[0]) - 90) <= 3


def test_a_height_that_changes_inside_a_track_is_told() -> None:
    run = made_run([Walk(straight((-3, 5), (0.5, 0), 160), looks=RED)])
    with_column(run, "signals", "height_m", run.signals["frame"] >= 90, 1.45)
    seen = found("height", run)
    assert abs(int(seen.frame[0]) - 90) <= 3
    assert seen.figure[0] == pytest.approx(0.3, abs=0.02)


def test_a_jump_is_told_where_it_lands() -> None:
    path = straight((-3, 5), (1, 0), 100)
    path[60:] += (0.0, 0.5)
    seen = found("jump", made_run([Walk(path)]))
    assert seen.frame.tolist() == [60]
    assert seen.figure[0] == pytest.approx(0.5, abs=0.05)


def test_two_people_seen_as_one_are_told_when_both_are_seen_again() -> None:
    walks = [
        Walk(straight((-2, 5), (0.5, 0), 100)),
        Walk(straight((-2, 5.4), (0.5, 0), 100), predicted=range(40, 60)),
    ]
    seen = found("shared", made_run(walks))
    assert seen.frame.tolist() == [60]
    assert seen.figure[0] == pytest.approx(1.0)


def test_somebody_out_of_sight_for_long_is_told_when_seen_again() -> None:
    seen = found("predicted", made_run([Walk(apart()[0].path, predicted=range(40, 70))]))
    assert seen.frame.tolist() == [70]
    assert seen.figure[0] == pytest.approx(1.5)


def test_a_track_that_goes_on_without_its_person_is_told_where_it_lost_it() -> None:
    seen = found("drift", made_run([Walk(apart()[0].path, predicted=range(60, 120))]))
    assert seen.frame.tolist() == [60]
    assert seen.figure[0] == pytest.approx(3.0)


def test_a_small_margin_is_about_whoever_is_near() -> None:
    run = made_run(crossing())
    where = (run.associations["track"] == 1) & (run.associations["frame"] == 80)
    with_column(run, "associations", "margin", where, 0.1)
    seen = found("margin", run)
    assert list(zip(seen.first, seen.second, seen.frame, strict=True)) == [(1, 2, 80)]


@pytest.mark.parametrize(("kind", "column"), [("spread", "spread_m"), ("split", "split")])
def test_particles_that_spread_or_fall_in_two_are_told(kind: str, column: str) -> None:
    run = made_run(apart())
    where = (run.signals["track"] == 2) & (run.signals["frame"] == 50)
    with_column(run, "signals", "spread_m", where, 0.4)
    with_column(run, "signals", column, where, 0.9)
    seen = found(kind, run)
    assert (seen.first.tolist(), seen.frame.tolist()) == ([2], [50])


def test_a_narrow_cloud_in_two_is_one_person() -> None:
    run = made_run(apart())
    with_column(run, "signals", "split", run.signals["frame"] == 50, 0.9)
    assert len(found("split", run)) == 0


def test_ends_and_beginnings_in_the_middle_of_the_floor_are_told() -> None:
    run = made_run([*apart(), Walk(straight((0, 5), (0, 0), 40), start=40)])
    assert found("begun", run).frame.tolist() == [40]
    assert found("ended", run).frame.tolist() == [79]


def test_a_lost_person_found_again_counts_less_in_other_clothes() -> None:
    path = straight((-3, 5), (1, 0), 160)

    def strength(looks: tuple[float, ...]) -> float:
        walks = [Walk(path[:70], looks=RED), Walk(path[80:], start=80, looks=looks)]
        return float(found("lost", made_run(walks)).strength[0])

    assert strength(BLUE) < 0.3 < strength(RED)


def test_failed_parts_are_told() -> None:
    run = made_run(apart())
    rows = {name: np.zeros(3, dtype) for name, dtype in PART_COLUMNS.items()}
    rows["frame"][:] = 50
    rows["track"][:] = (1, 1, 2)
    rows["part"][:] = (0, 1, 0)
    rows["failed"][:] = (True, True, False)
    run.parts.update(rows)
    seen = found("part", run)
    head_and_torso = 1 + 2
    assert list(zip(seen.first, seen.frame, seen.figure, strict=True)) == [(1, 50, head_and_torso)]
    assert seen.strength[0] == pytest.approx(2 / 3)


@pytest.mark.parametrize(
    ("which", "parts"), [(4, "hip-leg"), (3, "head and torso"), (7, "head, torso and hip-leg")]
)
def test_the_parts_that_failed_are_named(which: int, parts: str) -> None:
    assert sentence("part", 3, 0, which, 7.2) == f"the {parts} of 3 failed at 00:07.20"


def there_and_back(predicted: range) -> FlaggedPlaces:
    path = straight((-3, 5), (1.0, 0), 160)
    path[80:] = path[80] - (path[80:] - path[80])
    return found("reversal", made_run([Walk(path, predicted=predicted)]))


def test_a_track_that_turns_back_while_hidden_is_told() -> None:
    seen = there_and_back(range(76, 84))
    assert seen.first.tolist() == [1]
    assert abs(int(seen.frame[0]) - 80) <= 3
    assert seen.figure[0] == pytest.approx(1.0, abs=0.1)


def test_people_turn_back_in_full_view_as_they_like() -> None:
    assert len(there_and_back(range(0))) == 0


def test_who_walks_on_while_hidden_is_no_reversal() -> None:
    walk = Walk(straight((-3, 5), (1.0, 0), 160), predicted=range(70, 90))
    assert len(found("reversal", made_run([walk]))) == 0


def test_a_moment_that_is_not_the_very_one_is_said_to_be_about_then() -> None:
    said = sentence("colour", 3, 0, 0.0, 7.2, about=True)
    assert said == "3 has other colours from about 00:07.20 on"


def test_times_are_rounded_to_hundredths_not_cut_as_everywhere() -> None:
    times_s = (5.65, 59.996, 3600.0)
    said = [sentence("part", 3, 0, 7, time_s).split()[-1] for time_s in times_s]
    assert said == ["00:05.65", "01:00.00", "1:00:00.00"] == [*map(time_text, times_s)]


@pytest.mark.usefixtures("pseudo")
def test_a_reason_is_translated_with_all_its_words() -> None:
    assert tr(sentence("part", 3, 0, 7, 7.2, about=True)) == (
        "⟦the ⟦⟦head⟧, ⟦torso⟧ and ⟦hip-leg⟧⟧ of 3 failed at ⟦about 00:07.20⟧⟧"
    )
    for kind, words in WORDS.items():
        for second in (2 if words.two else 0, 0 if words.one else 2):
            said = sentence(kind, 1, second, 1.0, 7.2, on_floor=False)
            assert tr(said) != said
            assert tr(said).startswith("⟦")
