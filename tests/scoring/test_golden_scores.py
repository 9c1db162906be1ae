"""Scores equal those that TrackEval and py-motmetrics gave for kept sequences.

`python -m tests.peers.golden` makes the kept figures anew; `tests/sweeps/scorers.py` compares on
as many sequences as one likes.
"""

from __future__ import annotations

from pathlib import Path

import pytest
from golden_scores import WAYS, golden_figures, golden_sequences

from tests.peers.figures import COUNTS, Figures, differences, motmetrics_figures, trackeval_figures
from tracking.formats import read_mot
from tracking.scoring import Conventions, ScoringTable, combined, score

SEQUENCES = golden_sequences()
TRACKEVAL = golden_figures("trackeval")
MOTMETRICS = golden_figures("py-motmetrics")


def assert_equal(ours: Figures, theirs: Figures) -> None:
    assert theirs
    for name, apart in differences(ours, theirs).items():
        assert apart <= (0.0 if name in COUNTS else 1e-9), name


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", SEQUENCES)
def test_a_sequence_scores_as_in_trackeval(name: str, way: str) -> None:
    found = score(*SEQUENCES[name], WAYS[way])
    assert_equal(trackeval_figures(found), TRACKEVAL[way][name])


@pytest.mark.parametrize("way", WAYS)
def test_sequences_combine_as_in_trackeval(way: str) -> None:
    found = combined([score(*pair, WAYS[way]) for pair in SEQUENCES.values()])
    assert_equal(trackeval_figures(found), TRACKEVAL[way]["COMBINED_SEQ"])


def of_motmetrics(name: str, way: str) -> Figures:
    found = score(*SEQUENCES[name], WAYS[way], conventions=Conventions.MOTMETRICS)
    return motmetrics_figures(found)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", [name for name in MOTMETRICS["box"] if name in SEQUENCES])
def test_a_sequence_scores_as_in_py_motmetrics(name: str, way: str) -> None:
    assert_equal(of_motmetrics(name, way), MOTMETRICS[way][name])


@pytest.mark.parametrize("way", WAYS)
def test_sequences_combine_as_in_py_motmetrics(way: str) -> None:
    names = [name for name in MOTMETRICS[way] if name in SEQUENCES]
    scores = [
        score(*SEQUENCES[name], WAYS[way], conventions=Conventions.MOTMETRICS) for name in names
    ]
    theirs = dict(MOTMETRICS[way]["OVERALL"])
    if theirs["motp"] is None:
        # One sequence without a match makes its mean over all undefined; ours is not.
        del theirs["motp"]
    assert_equal(motmetrics_figures(combined(scores)), theirs)


@pytest.mark.parametrize("name", ["TUD-Campus", "TUD-Stadtmitte"])
def test_a_public_pair_scores_as_in_both(shared_data: Path, name: str) -> None:
    folder = shared_data / "scoring" / name
    truth = ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)
    result = ScoringTable.from_columns(read_mot(folder / "result.txt"))
    kept = golden_figures("public-pairs")
    assert_equal(
        trackeval_figures(score(truth, result)), without_track_map(kept["trackeval"][name])
    )
    found = score(truth, result, conventions=Conventions.MOTMETRICS)
    assert_equal(motmetrics_figures(found), kept["py-motmetrics"][name])


def without_track_map(theirs: Figures) -> Figures:
    """The pairs' tracker tells no confidences."""
    return {name: value for name, value in theirs.items() if not name.startswith("TrackMAP")}


def test_public_pairs_combine_as_in_trackeval(shared_data: Path) -> None:
    folders = sorted((shared_data / "scoring").iterdir())
    scores = [
        score(
            ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True),
            ScoringTable.from_columns(read_mot(folder / "result.txt")),
        )
        for folder in folders
    ]
    theirs = golden_figures("public-pairs")["trackeval"]["COMBINED_SEQ"]
    assert_equal(trackeval_figures(combined(scores)), without_track_map(theirs))


def test_the_two_conventions_differ_on_the_kept_sequences() -> None:
    """Else the switch would be tested by nothing."""
    usual = {name: motmetrics_figures(score(*pair)) for name, pair in SEQUENCES.items()}
    differ = {
        figure
        for name, figures in MOTMETRICS["box"].items()
        if name in usual
        for figure, apart in differences(usual[name], figures).items()
        if apart > 1e-9 and figure != "motp"
    }
    assert {"num_switches", "num_fragmentations", "num_false_positives", "mota"} <= differ
