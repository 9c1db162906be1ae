"""TrackEval's time and memory: `trackeval_timed.py SEQUENCES`, in TrackEval's environment.

From boxes in memory by frame, with ids already numbered from 0: overlaps, CLEAR, identity, HOTA.
Its reading and preparing of a sequence, which takes longer than that, is left out.
"""

import json
import sys
import time
import warnings

import numpy as np
from peaks import forget_peak, peak_kib
from sequences import by_frame, read_sequences

warnings.simplefilter("ignore")

from trackeval.datasets import MotChallenge2DBox  # noqa: E402
from trackeval.metrics import CLEAR, HOTA, Identity  # noqa: E402


def side(rows, frames):
    """A side by frame: numbers from 0, boxes counted from pixel 1."""
    rows[:, 1] = np.unique(rows[:, 1], return_inverse=True)[1]
    parts = by_frame(rows, frames)
    ids = [part[:, 1].astype(int) for part in parts]
    return ids, [part[:, 2:6] + [1.0, 1.0, 0.0, 0.0] for part in parts], int(rows[:, 1].max()) + 1


def main():
    """Print the time, the peak of memory and three figures."""
    ((truth, result),) = read_sequences(sys.argv[1]).values()
    frames = 1 + int(max(truth[-1, 0], result[-1, 0]))
    truth_rows, result_rows = len(truth), len(result)
    people, boxes, people_count = side(truth, frames)
    tracks, found, track_count = side(result, frames)
    del truth, result
    quiet = {"PRINT_CONFIG": False}
    metrics = [CLEAR(dict(quiet, THRESHOLD=0.5)), Identity(dict(quiet, THRESHOLD=0.5)), HOTA()]
    forget_peak()
    begun = time.process_time()
    ious = MotChallenge2DBox._calculate_box_ious
    data = {
        "num_timesteps": frames, "gt_ids": people, "tracker_ids": tracks,
        "num_gt_ids": people_count, "num_tracker_ids": track_count,
        "num_gt_dets": truth_rows, "num_tracker_dets": result_rows,
        "similarity_scores": [ious(a, b) for a, b in zip(boxes, found, strict=True)],
    }  # fmt: skip
    results = {}
    for metric in metrics:
        results |= metric.eval_sequence(data)
    taken = time.process_time() - begun
    peak = peak_kib()
    figures = {name: float(np.mean(results[name])) for name in ("MOTA", "IDF1", "HOTA")}
    print(json.dumps({"seconds": taken, "peak_kib": peak} | figures))


if __name__ == "__main__":
    main()
