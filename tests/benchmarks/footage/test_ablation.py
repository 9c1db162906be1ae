"""The bench of mechanisms: each can be left out, and worths say what chance leaves of them."""

from __future__ import annotations

from argparse import Namespace
from itertools import chain
from pathlib import Path
from typing import Any

import pytest

from tests.benchmarks.footage import ablation
from tests.benchmarks.footage.ablation import SCORES, WITH_ALL, groups_of, rows_of, worth_of
from tests.benchmarks.footage.mechanisms import MECHANISMS, Mechanism
from tests.benchmarks.runner import Case, replacing
from tracking.trackers.linking import appearance, extend_ends, linker

_ALL = [(tracker, one) for tracker, its in MECHANISMS.items() for one in its]


@pytest.mark.parametrize(("tracker", "mechanism"), _ALL, ids=lambda one: getattr(one, "name", one))
def test_what_a_mechanism_leaves_out_is_there(tracker: str, mechanism: Mechanism) -> None:
    assert (
        mechanism.replaced or Case(tracker, mechanism.settings).chosen() != Case(tracker).chosen()
    )
    with replacing(mechanism.replaced):
        pass


def test_mechanisms_of_a_tracker_have_names_of_their_own_and_a_group() -> None:
    for tracker, its in MECHANISMS.items():
        names = [one.name for one in its]
        assert len(set(names)) == len(names)
        grouped = chain.from_iterable(group for _, group in groups_of(tracker))
        assert sorted(one.name for one in grouped) == sorted(names)


def test_a_mechanism_is_left_out_where_it_is_used() -> None:
    (named,) = (one for one in MECHANISMS["stereo-joint"] if one.name == "appearance")
    (extended,) = (one for one in MECHANISMS["stereo-joint"] if one.name == "extended ends")
    before = linker.extend_ends
    with replacing((*named.replaced, *extended.replaced)):
        assert linker.extend_ends is not before
        assert linker.extend_ends(3) == 3
        assert appearance._TRUSTED == 0.0
    assert linker.extend_ends is before is extend_ends.extend_ends
    assert appearance._TRUSTED > 0.0


def test_a_worth_is_sure_where_seeds_agree() -> None:
    sure = worth_of([[0.9, 0.91], [0.8, 0.79]], [[0.8, 0.81], [0.6, 0.59]])
    assert sure.mean == pytest.approx(0.15)
    assert sure.is_sure
    unsure = worth_of([[0.9, 0.5], [0.5, 0.9]], [[0.8, 0.7], [0.7, 0.6]])
    assert not unsure.is_sure
    assert not worth_of([[0.9]], [[0.1]]).is_sure


def test_what_is_measured_again_stays_apart(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ablation, "FIGURES", tmp_path / "ablation.json")
    monkeypatch.setattr(ablation, "PAGE", tmp_path / "ablation.md")
    asked = Namespace(tracker="stereo-joint", group="finishing", seeds=[3, 4], frames=(9, 9))
    for again, score in ((False, 0.9), (True, 0.5)):
        one = {**dict.fromkeys(SCORES, score), "tracks": str(score)}
        found = {WITH_ALL: {"own-a": [one, one]}, "linking": {"own-a": [one, one]}}
        ablation._keep(Namespace(**vars(asked), again=again), found)
    ablation.write_page()
    kept = ablation.figures()
    assert kept["stereo-joint"]["finishing"]["linking"]["own-a"][0]["MOTA"] == 0.9
    assert [one["found"]["linking"]["own-a"][0]["MOTA"] for one in kept["again"]] == [0.5]
    page = (tmp_path / "ablation.md").read_text(encoding="utf-8")
    assert page.index("| linking | tracks are cut") < page.index(
        "| stereo-joint | linking | own-a, 9"
    )


def test_rows_tell_what_falls_and_on_how_many_recordings_anything_changes() -> None:
    def run(score: float, tracks: str) -> dict[str, Any]:
        return {**dict.fromkeys(SCORES, score), "tracks": tracks}

    whole = {"own-a": [run(0.9, "a"), run(0.9, "b")], "rendered-b": [run(0.7, "c"), run(0.7, "d")]}
    without = {"own-a": [run(0.8, "x"), run(0.8, "y")], "rendered-b": whole["rendered-b"]}
    told = {"stereo-joint": {"finishing": {WITH_ALL: whole, "linking": without}}}
    (row,) = rows_of(told)
    assert row["MOTA all"].mean == pytest.approx(0.05)
    assert row["MOTA own"].mean == pytest.approx(0.1)
    assert row["MOTA other"].mean == 0.0
    assert row["MOTA real"] is None
    assert (row["changed"], row["recordings"]) == (1, ["own-a", "rendered-b"])
