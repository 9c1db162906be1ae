"""Our time and memory for a sequence: `python -m tests.peers.ours_timed SEQUENCES`.

From tables in memory, as the peers from their own form of the rows: every measure there is.
"""

from __future__ import annotations

import json
import sys
import time

import numpy as np

from tests.peers.peaks import forget_peak, peak_kib
from tests.peers.sequences import COLUMNS, read_sequences
from tracking.scoring import ScoringTable, score


def main() -> None:
    """Print the time, the peak of memory and three figures."""
    ((truth, result),) = read_sequences(sys.argv[1]).values()
    people, tracks = _table(truth), _table(result)
    del truth, result
    forget_peak()
    begun = time.process_time()
    found = score(people, tracks)
    taken = time.process_time() - begun
    peak = peak_kib()
    figures = {"MOTA": found.clear.mota, "IDF1": found.identity.idf1, "HOTA": found.hota.hota}
    print(json.dumps({"seconds": taken, "peak_kib": peak} | figures))


def _table(rows: np.ndarray) -> ScoringTable:
    """Boxes only: neither peer looks at places or confidences."""
    return ScoringTable.from_columns(dict(zip(COLUMNS[:6], rows[:, :6].T, strict=True)))


if __name__ == "__main__":
    main()
