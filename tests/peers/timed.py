"""A scorer's time and memory in a process of its own: `timed.py NAME SEQUENCES`, said as JSON.

Of one sequence, in memory, in whatever form the scorer reads without copying. Runs in the peers'
environments too. TrackEval's reading and preparing of a sequence, which takes longer than its
measuring, is left out.
"""

import json
import resource
import sys
import time
import warnings
from pathlib import Path

import numpy as np
from sequences import COLUMNS, by_frame, read_tables

_SELF = Path("/proc/self")


def ours(truth, result):
    """Every measure there is, of boxes only: neither peer looks at places or confidences."""
    from tracking.scoring import ScoringTable, score

    people, tracks = (
        ScoringTable.from_columns(dict(zip(COLUMNS[:6], rows[:, :6].T, strict=True)))
        for rows in (truth, result)
    )

    def measure():
        found = score(people, tracks)
        return found.clear.mota, found.identity.idf1, found.hota.hota

    return measure


def motrics(truth, result):
    """Boxes by frame as corners counted from pixel 1: everything it measures at once."""
    import motrics as scorer

    frames = 1 + int(max(truth[-1, 0], result[-1, 0]))

    def side(rows):
        parts = by_frame(rows, frames)
        low = [part[:, 2:4] + 1.0 for part in parts]
        corners = [np.hstack([at, at + part[:, 4:6]]) for at, part in zip(low, parts, strict=True)]
        return scorer.Frames([part[:, 1].astype(int).tolist() for part in parts], corners)

    people, tracks = side(truth), side(result)

    def measure():
        found = scorer.evaluate(people, tracks)
        return found.clear.mota, found.identity.idf1, found.hota.hota

    return measure


def trackeval(truth, result):
    """Boxes by frame counted from pixel 1, ids from 0: overlaps, CLEAR, identity, HOTA."""
    warnings.simplefilter("ignore")
    from trackeval.datasets import MotChallenge2DBox
    from trackeval.metrics import CLEAR, HOTA, Identity

    frames = 1 + int(max(truth[-1, 0], result[-1, 0]))
    data, boxes = {"num_timesteps": frames}, []
    for name, rows in (("gt", truth), ("tracker", result)):
        rows[:, 1] = np.unique(rows[:, 1], return_inverse=True)[1]
        parts = by_frame(rows, frames)
        boxes.append([part[:, 2:6] + [1.0, 1.0, 0.0, 0.0] for part in parts])
        data[f"{name}_ids"] = [part[:, 1].astype(int) for part in parts]
        data |= {f"num_{name}_ids": int(rows[:, 1].max()) + 1, f"num_{name}_dets": len(rows)}
    config = {"PRINT_CONFIG": False, "THRESHOLD": 0.5}
    metrics = [CLEAR(config), Identity(config), HOTA()]

    def measure():
        ious, told = MotChallenge2DBox._calculate_box_ious, {}
        whole = data | {"similarity_scores": [ious(a, b) for a, b in zip(*boxes, strict=True)]}
        for metric in metrics:
            told |= metric.eval_sequence(whole)
        return [np.mean(told[name]) for name in ("MOTA", "IDF1", "HOTA")]

    return measure


def forget_peak():
    """What was taken so far no longer counts, on Linux."""
    try:
        (_SELF / "clear_refs").write_text("5", encoding="ascii")
    except OSError:
        return


def peak_kib():
    """The most memory of the process since then, data in memory included."""
    try:
        lines = (_SELF / "status").read_text(encoding="ascii").splitlines()
    except OSError:
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM"))


if __name__ == "__main__":
    (pair,) = read_tables(sys.argv[2]).values()
    scorer = {"ours": ours, "motrics": motrics, "trackeval": trackeval}[sys.argv[1]](*pair)
    del pair
    forget_peak()
    begun = time.process_time()
    figures = scorer()
    taken = time.process_time() - begun
    told = dict(zip(("MOTA", "IDF1", "HOTA"), map(float, figures), strict=True))
    print(json.dumps({"seconds": taken, "peak_kib": peak_kib()} | told))
