"""The page of the stereo trackers, made of figures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.benchmarks.intervals import interval
from tests.benchmarks.stereo import overview, papers, peers, reasons
from tests.benchmarks.stereo.__main__ import PAGE
from tests.benchmarks.stereo.clips import (
    AS_THEY_COME,
    COLUMNS,
    FRESH,
    OWN,
    REPORTED,
    TUNED,
    columns_of,
)
from tests.benchmarks.stereo.goals import ACCURACY_GOALS, advice
from tests.benchmarks.stereo.measures import passages_by_eye
from tests.benchmarks.stereo.papers import sentences
from tests.benchmarks.stereo.pictures import typical
from tracking.synthesis import SCENES
from tracking.trackers import TRACKERS


def _section(name: str, figures: Any) -> str:
    return PAGE.sections({name: figures})[name]


def _lost(name: str, what: str = reasons.RENAMED, where: str = "behind somebody") -> dict[str, Any]:
    clip, _, person = name.partition("/")
    around = {"where": where, "neighbour": 2, "share": 0.1}
    row = {"person": int(person), "what": what, "frame": 50, "last": 40, "other": 0}
    return {"name": name, "clip": clip, **row, "tracks": [1, 2], **around}


def _column(
    kept: int, not_kept: list[dict[str, Any]] | None = None, of: int = 10
) -> dict[str, Any]:
    people = [f"lobby-1/{n}" for n in range(1, of + 1)]
    lost = not_kept if not_kept is not None else [_lost(name) for name in people[kept:]]
    names = {row["name"] for row in lost}
    held = [name for name in people if name not in names]
    found = {"detected": people, "kept": held, "not_kept": lost}
    return {**found, "detected_by_place": people, "kept_by_place": people}


def _tables(*kept: int) -> dict[str, Any]:
    return {"lobby": dict(zip(COLUMNS, map(_column, kept), strict=True))}


def _tells_of_cues(page: str) -> tuple[bool, bool]:
    """Whether cues that kept nobody more are introduced, and whether one of them is told of."""
    return "Cues that kept nobody more" in page, "kept without it" in page


def test_wilson_s_interval_of_few_people_is_wide() -> None:
    assert interval(9, 10) == pytest.approx((0.5958, 0.9821), abs=1e-4)
    assert interval(0, 0) == (0.0, 1.0)


def test_one_sentence_sets_the_papers_methods_beside_the_papers_figures() -> None:
    said = papers.summary(_tables(7, 8, 10, 10))
    assert "reach the papers' figures in 1 of 2 places where both exist by box (2 by place)" in said
    assert "8.0 points (lobby, 2.4 m, 30 degrees, distance + colour)" in said
    assert "`stereo-joint` is above the paper's best figure in the only scene" in said
    assert papers.summary({"uniforms": _tables(7, 8, 9, 10)["lobby"]}) == ""


def test_a_cue_that_helps_gets_no_sentence_and_one_that_does_not_says_why() -> None:
    assert list(sentences(_tables(7, 8, 9, 10))) == []
    swapped = [_lost("lobby-1/1", reasons.SWAPPED), _lost("lobby-1/9")]
    columns = (_column(9, [_lost("lobby-1/9")]), _column(8, swapped), _column(10))
    figures = {"lobby": dict(zip(COLUMNS, (*columns, _column(10)), strict=True))}
    (said,) = sentences(figures)
    assert said.startswith("**Lobby, 2.4 m, 30 degrees, colour**: 9 kept without it, 8 with it")
    assert "8 with it, of 10 (by place 10 and 10)." in said
    assert "It won nobody and lost 1 (1 swapped, behind somebody)." in said
    assert "Not kept either way: 1 (1 new id), none of them a cue's to decide" in said


def test_a_cue_without_effect_is_told_by_what_there_was_to_choose() -> None:
    rest = [_lost("lobby-1/1", reasons.SWAPPED), _lost("lobby-1/9"), _lost("lobby-1/8")]
    figures = {"lobby": dict.fromkeys(COLUMNS, _column(7, rest))}
    first, second = sentences(figures)
    assert "It changed nobody's lot." in first
    assert "Not kept either way: 3 (2 new id, 1 swapped), 1 of them a cue's to decide" in first
    assert "direction" in second


def test_reasons_are_given_for_what_cues_did_and_for_nothing_else() -> None:
    doubled = [_lost("lobby-1/1", reasons.DOUBLED)]
    columns = (_column(10), _column(9, doubled), _column(9, doubled), _column(10))
    page = _section("tables", {"lobby": dict(zip(COLUMNS, columns, strict=True))})
    assert _tells_of_cues(page) == (True, True)
    assert "seen in two pieces" in page
    assert "half hidden" not in page


def test_every_column_is_the_papers_own_method_but_ours() -> None:
    for scene in ("indoor", "lobby"):
        columns = columns_of(scene)
        exact = [case for name, case in columns.items() if name != OWN]
        assert all(case.chosen().paper for case in exact)


def test_clips_reported_are_never_those_of_choosing_and_hold_people_enough() -> None:
    for scene in ACCURACY_GOALS:
        clips = REPORTED[scene]
        assert sum(SCENES[scene].people - 1 for _ in clips) >= 30
        assert not {clip.seed for clip in clips} & {clip.seed for clip in TUNED[scene]}


def test_fresh_clips_are_four_times_as_many_and_share_no_seed_with_others() -> None:
    for scene, clips in FRESH.items():
        assert len(clips) == 4 * len(REPORTED[scene])
        seeds = {clip.seed for clip in clips}
        assert min(seeds) >= 6306
        assert not seeds & {clip.seed for clip in REPORTED[scene]}
        assert not seeds & {clip.seed for clip in TUNED[scene]}
    assert len(FRESH["indoor"]) == 12
    assert len(FRESH["ceiling"]) == 4


def _scored(kept: int, seed: int, of: int = 25, **others: float) -> dict[str, Any]:
    shares = {"MOTA": 0.9, "IDF1": 0.97, "HOTA": 0.8, "error_m": 0.12, "id_switches": 3}
    people = {"people_kept": kept, "people_detected": of, "visible": 26, "visible_detected": 25}
    rows = {"misses": 30, "false_positives": 10, "truth_rows": 1000}
    by_clip = {"kept_by_clip": [8, kept - 8], "detected_by_clip": [10, of - 10]}
    clips = {"clips": [f"lobby-{seed}", f"lobby-{seed + 1}"], **by_clip}
    by_floor = {"people_kept": of, "people_detected": of, "tracking_accuracy": 1.0}
    own = {"tracking_accuracy": kept / of, "by_floor": by_floor}
    return {**own, **shares, **people, **rows, **clips, **others}


def _goals(fresh: int = 20, often: int = 25, of: int = 25) -> dict[str, Any]:
    return {"fresh": {"lobby": _scored(fresh, 6303, of)}, "often": {"lobby": _scored(often, 6101)}}


def test_it_is_said_in_words_what_is_met_on_fresh_clips_and_whether_the_others_flatter() -> None:
    page = _section("goals", _goals())
    assert "20 of 25 people were kept, 0.800 (0.61 to 0.91)" in page
    assert "Tracking accuracy: met in none of 1 scene; missed in lobby, 2.4 m, 30 degrees" in page
    assert "by floor, counted since those by box were known: met in the only scene." in page
    assert "IDF1: met in the only scene." in page
    assert "more than chance explains" in _section("goals", _goals(18))
    assert "may be chance" in _section("goals", _goals(24))


def test_clips_added_once_others_were_known_are_told_apart() -> None:
    page = _section("goals", _goals())
    assert "8 of 10 people were kept in the first round, 12 of 15 in the other" in page
    assert "rounds" not in _section("goals", {**_goals(), "fresh": {}})


def test_goals_without_fresh_clips_are_not_judged() -> None:
    page = _section("goals", {"fresh": {}, "often": _goals()["often"]})
    assert "not been measured" in page
    assert "met" not in page.partition("not been measured")[2].replace("metres", "")


def _choice(*rows: dict[str, Any]) -> dict[str, Any]:
    named = dict(zip(map(str, AS_THEY_COME), rows, strict=True))
    return {"all": named, "scenes": {"lobby": named}, "clips": ["lobby-6303"]}


def _timed(kept: int, following_ms: float, **others: float) -> dict[str, Any]:
    return {**_scored(kept, 6303), "following_ms": following_ms, "seeing_ms": 9.0, **others}


def test_which_tracker_to_take_is_told_by_what_each_is_best_at() -> None:
    joint, direction = _timed(24, 2.0, MOTA=0.95), _timed(20, 1.5, MOTA=0.97)
    said = advice(_choice(joint, direction, _timed(19, 1.0))["all"])
    assert said.startswith("Take `stereo-joint` where everybody must keep one id (24 of 25 kept,")
    assert "`stereo-direction` where every box counts and ids do not (MOTA 0.970," in said
    assert "`stereo-colour` where time is short (1.00 ms a frame" in said


def test_a_tracker_that_is_ahead_in_everything_is_told_once() -> None:
    joint, direction = _timed(24, 1.0, MOTA=0.99), _timed(20, 1.5, MOTA=0.97)
    said = advice(_choice(joint, direction, _timed(19, 2.5))["all"])
    assert said.count("`stereo-joint`") == 1
    assert "ahead in everything" in said


def test_every_tracker_for_two_cameras_is_compared_as_it_comes() -> None:
    assert {spec.name for spec in TRACKERS.values() if spec.needs_stereo} == set(
        map(str, AS_THEY_COME)
    )


def test_the_overview_gives_the_figures_of_the_results_page() -> None:
    text = overview.OVERVIEW.read_text(encoding="utf-8")
    assert text.count(overview.BEGIN) == text.count(overview.END) == 1
    wanted = overview.with_passage(text, PAGE.figures())
    assert text == wanted, "run python -m tests.benchmarks.stereo.overview"


def test_what_goes_wrong_is_counted_by_scene_and_the_most_frequent_are_shown() -> None:
    people = {"lobby": [_lost("lobby-1/3"), _lost("lobby-1/4"), _lost("lobby-1/5", "swapped")]}
    shown = typical(people)
    assert [one["person"] for one in shown] == [3, 5]
    page = _section("lost", {"people": people, "shown": shown})
    assert "| scene | not kept | swapped | new id |" in page
    assert "| lobby, 2.4 m, 30 degrees | 3 | 1 | 2 |" in page
    assert "- swapped: two people exchanged" in page
    assert "- old track:" not in page
    assert "beside somebody" not in page
    assert "lobby-1, person 3: new id, behind somebody, frames 40 to 50." in page


def test_both_people_of_one_false_match_are_not_shown_twice() -> None:
    pair = [_lost("lobby-1/2", reasons.FALSE), _lost("lobby-1/8", reasons.FALSE, "in the open")]
    pair[0]["other"], pair[1]["other"] = 8, 2
    others = [_lost("square-1/8", reasons.FALSE, "in the open"), _lost("square-1/9")]
    assert [one["name"] for one in typical({"lobby": pair, "square": others})] == [
        "lobby-1/8",
        "square-1/9",
    ]
    assert [one["name"] for one in typical({"lobby": pair})] == ["lobby-1/2"]


def _passes(*spans: tuple[int, int, int]) -> dict[str, np.ndarray]:
    rows = [(frame, track) for track, start, end in spans for frame in range(start, end)]
    table = np.array(sorted(rows))
    return {"frame": table[:, 0], "track": table[:, 1]}


def test_a_passage_belongs_to_the_track_that_covers_most_of_it_and_others_are_extra() -> None:
    found = passages_by_eye(
        _passes((1, 60, 111), (2, 180, 321), (3, 380, 471), (4, 480, 571), (5, 330, 345), (6, 5, 9))
    )
    assert [row["covered"] for row in found["passages"]] == [51, 141, 91, 91]
    assert [row["track"] for row in found["extra"]] == [5]
    assert found["short"] == 1
    page = _section("real", found)
    assert "4 tracks of their own (met)." in page
    assert "1: 5 (frames 330 to 344) (missed)." in page
    assert "40 of the 414 frames of the passages have no track, 40 of them before it" in page


def test_missing_footage_is_said() -> None:
    assert "Not measured: the overhead recording" in _section("real", {})


def _peer(
    tracker: str,
    switches: int | None,
    *,
    ours: bool = False,
    colour: bool = False,
    finished: bool = True,
) -> Any:
    told = {"id_switches": switches, "people": 15, "kept": 9, "idf1": 0.9, "hota": 0.8}
    told |= {"floor_error_m": 0.05, "ms": 1.0}
    row = {
        "tracker": tracker,
        "ours": ours,
        "colour": colour,
        "finished": ours and finished,
        "absent": "",
    }
    return {**row, "figures": None if switches is None else told}


def test_switches_are_held_against_the_best_of_the_others_that_are_there() -> None:
    own = [_peer("stereo-joint", 8, ours=True), _peer("stereo-joint", 5, ours=True, colour=True)]
    said = peers.verdicts([*own, _peer("SORT", 30), _peer("motpy", 9), _peer("norfair", None)])
    assert "motpy, 9." in said
    assert "no more: stereo-joint 8 finished (met)" in said
    assert "at most half: stereo-joint 5 finished (missed)" in said
    assert "None of the others" in peers.verdicts([*own, _peer("norfair", None)])


def test_half_of_no_switches_is_no_goal_and_colours_that_do_harm_are_told() -> None:
    own = [
        _peer("stereo-joint", switches, ours=True, colour=colour, finished=finished)
        for colour, finished, switches in (
            (False, False, 0), (False, True, 0), (True, False, 3), (True, True, 0)
        )
    ]  # fmt: skip
    said = peers.verdicts([*own, _peer("SORT", 0)])
    assert "no more: stereo-joint 0 finished (met)" in said
    assert "Half of none is none, so that with colours no more is asked" in said
    assert "As they come, colours cost stereo-joint 3 switches here (3, without colours 0)" in said
    assert "finishing takes them back" in said


def test_a_tracker_of_others_that_could_not_be_measured_says_why() -> None:
    absent = {**_peer("norfair", None), "absent": "norfair is not installed"}
    own = [_peer("stereo-joint", 8, ours=True), _peer("stereo-joint", 5, ours=True, colour=True)]
    figures = {kind: [*own, absent] for kind in ("crossing", "rendered")}
    page = _section("peers", {**figures, "clips": ["lobby-1"]})
    assert "| norfair | norfair is not installed |" in page
    assert "| stereo-joint, with colours, finished | 5 | 0.900 |" in page
