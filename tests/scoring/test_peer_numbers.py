"""Numbers of TrackEval, the reference the field compares with.

They were obtained by running TrackEval (commit 12c8791, NumPy 1.23, SciPy 1.15) on the same rows:
its `MotChallenge2DBox` preprocessing, with don't-cares given as class 8 (distractor) and conf 0,
then `CLEAR`, `Identity` and `HOTA` with their default settings; HOTA's four are means over alpha.
Nothing of TrackEval is kept here but these numbers.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from scenes_of_rows import pseudo_random

from tracking.formats import read_mot
from tracking.scoring import Score, ScoringTable, score

NAMES = (
    *("frames", "truth_people", "id_switches", "fragmentations", "false_positives", "misses"),
    *("mostly_tracked", "mostly_lost"),
    *("MOTA", "MOTP", "IDF1", "IDP", "IDR", "HOTA", "DetA", "AssA", "LocA"),
)
CAMPUS = (
    *(71, 8, 7, 7, 13, 150, 1, 1),
    *(0.5264623955431755, 0.7227989153605385),
    *(0.5576592082616179, 0.7297297297297297, 0.45125348189415043),
    *(0.3913974378451139, 0.418047030142763, 0.36912068120832836, 0.770052227022172),
)
STADTMITTE = (
    *(179, 10, 7, 6, 45, 452, 5, 1),
    *(0.5640138408304498, 0.6540957044559904),
    *(0.6446194225721785, 0.8197596795727636, 0.5311418685121108),
    *(0.3978490169927877, 0.3922675723693166, 0.40884075181129964, 0.7375211771780615),
)
CROWDS = {
    (1, 4, 60): (
        *(60, 4, 21, 53, 56, 36, 3, 0),
        *(0.3505747126436782, 0.7924539852538972),
        *(0.6902173913043478, 0.654639175257732, 0.7298850574712644),
        *(0.4716688699215854, 0.4860321461387704, 0.4587146324740225, 0.8146407402256419),
    ),
    (2, 9, 80): (
        *(80, 9, 104, 175, 154, 108, 5, 0),
        *(0.3146067415730337, 0.7930632739299538),
        *(0.6714542190305206, 0.6448275862068965, 0.700374531835206),
        *(0.45393917301112635, 0.49044484720014603, 0.42064143713455104, 0.8167625705883802),
    ),
    (3, 2, 30): (
        *(30, 2, 6, 12, 18, 9, 0, 0),
        *(0.13157894736842105, 0.8070109301137675),
        *(0.611764705882353, 0.5531914893617021, 0.6842105263157895),
        *(0.40605314102011114, 0.4291947069623398, 0.3850404391592887, 0.8318041283904638),
    ),
    (4, 12, 50): (
        *(50, 12, 114, 132, 120, 86, 9, 0),
        *(0.30585683297180044, 0.791207488773371),
        *(0.6757322175732218, 0.6525252525252525, 0.7006507592190889),
        *(0.4634117309620531, 0.5268575852914076, 0.4089434119712862, 0.8163653172864759),
    ),
}


def assert_equals(found: Score, expected: tuple[float, ...]) -> None:
    numbers: dict[str, Any] = found.as_json()
    for name, value in zip(NAMES, expected, strict=True):
        if isinstance(value, int):
            assert numbers[name] == value, name
        else:
            assert numbers[name] == pytest.approx(value, rel=0, abs=1e-12), name


@pytest.mark.parametrize("made_with", CROWDS, ids=str)
def test_crowds_score_as_in_trackeval(made_with: tuple[int, int, int]) -> None:
    truth, result = pseudo_random(*made_with)
    assert_equals(score(truth, result), CROWDS[made_with])


@pytest.mark.parametrize(
    ("name", "expected"), [("TUD-Campus", CAMPUS), ("TUD-Stadtmitte", STADTMITTE)]
)
def test_public_pairs_score_as_in_trackeval(
    shared_data: Path, name: str, expected: tuple[float, ...]
) -> None:
    folder = shared_data / "scoring" / name
    truth = ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)
    result = ScoringTable.from_columns(read_mot(folder / "result.txt"))
    assert_equals(score(truth, result), expected)
