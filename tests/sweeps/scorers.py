"""Our scores against TrackEval's and py-motmetrics': `scorers.py [COUNT] [SEED]`.

They are compared on so many random sequences and on all of them combined. Each peer runs in an
environment of its own, see `python -m tests.peers`.
"""

from __future__ import annotations

import argparse
import random
import sys
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

import numpy as np

from tests.peers.apart import COUNTS, Figures, differences
from tests.peers.drawn_sequences import Sequence, drawn, tables
from tests.peers.environments import MOTMETRICS, TRACKEVAL
from tests.peers.golden import told_by
from tests.peers.motmetrics_names import motmetrics_figures
from tests.peers.trackeval_names import trackeval_figures
from tracking.scoring import BoxMatch, Conventions, FloorMatch, Match, Score, combined, score

NEAR = 1e-9
WAYS: dict[str, Match] = {"box": BoxMatch(), "floor": FloorMatch(0.5)}
"""How rows are matched, by the names of the peers' scripts."""


def main() -> int:
    """Compare, and say how far apart the farthest figures are."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("count", type=int, nargs="?", default=400)
    parser.add_argument("seed", type=int, nargs="?", default=random.SystemRandom().randrange(2**32))
    asked = parser.parse_args()
    print(f"seed {asked.seed}", flush=True)
    sequences = drawn(asked.count, asked.seed)
    wrong = against_trackeval(sequences) + against_motmetrics(sequences)
    for line in wrong[:20]:
        print(line)
    return 1 if wrong else 0


def against_trackeval(sequences: dict[str, Sequence]) -> list[str]:
    """What differs from TrackEval, a line each."""
    theirs = told_by(TRACKEVAL, "trackeval_scores.py", sequences)
    wrong: list[str] = []
    for way, match in WAYS.items():
        scores = {name: score(*tables(one), match) for name, one in sequences.items()}
        ours = with_combined(scores, "COMBINED_SEQ", trackeval_figures)
        wrong += compared(f"TrackEval, {way}", ours, theirs[way])
    return wrong


def against_motmetrics(sequences: dict[str, Sequence]) -> list[str]:
    """What differs from py-motmetrics, a line each."""
    theirs = told_by(MOTMETRICS, "motmetrics_scores.py", sequences)
    wrong: list[str] = []
    for way, match in WAYS.items():
        scores = {
            name: score(*tables(sequences[name]), match, conventions=Conventions.MOTMETRICS)
            for name in theirs[way]
            if name in sequences
        }
        ours = with_combined(scores, "OVERALL", motmetrics_figures)
        if theirs[way]["OVERALL"]["motp"] is None:
            # One sequence without a match makes its mean over all undefined; ours is not.
            del theirs[way]["OVERALL"]["motp"]
        wrong += compared(f"py-motmetrics, {way}", ours, theirs[way])
    return wrong


def with_combined(
    scores: dict[str, Score], name: str, figures: Callable[[Score], Figures]
) -> dict[str, Figures]:
    """Each score's figures, and those of all together under the peer's name for that."""
    found = {one: figures(each) for one, each in scores.items()}
    return found | {name: figures(combined(list(scores.values())))}


def compared(whom: str, ours: dict[str, Figures], theirs: dict[str, Figures]) -> list[str]:
    """What is too far apart, a line each; prints how far the farthest is."""
    apart = {
        (name, figure): far
        for name, one in ours.items()
        for figure, far in differences(one, theirs[name]).items()
    }
    farthest = max(apart.values())
    print(f"{whom}: {len(ours)} scores, {len(apart)} figures, the farthest {farthest:.1e} apart")
    return [
        f"{whom}, sequence {name}: {figure} is {far:g} away"
        for (name, figure), far in apart.items()
        if far > (0.0 if figure in COUNTS else NEAR)
    ]


if __name__ == "__main__":
    np.seterr(all="raise")
    sys.exit(main())
