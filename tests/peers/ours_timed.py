"""Our time and memory: `python -m tests.peers.ours_timed SEQUENCES`; see `timed.print_timed`.

From tables in memory, as the peers from their own form of the rows: every measure there is.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import numpy as np
from sequences import COLUMNS
from timed import print_timed

from tracking.scoring import ScoringTable, score


def prepare(truth: np.ndarray, result: np.ndarray) -> Callable[[], tuple[float, float, float]]:
    """Boxes only: neither peer looks at places or confidences."""
    people, tracks = (
        ScoringTable.from_columns(dict(zip(COLUMNS[:6], rows[:, :6].T, strict=True)))
        for rows in (truth, result)
    )

    def measure() -> tuple[float, float, float]:
        found = score(people, tracks)
        return found.clear.mota, found.identity.idf1, found.hota.hota

    return measure


if __name__ == "__main__":
    print_timed(prepare)
