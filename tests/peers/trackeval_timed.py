"""TrackEval's time and memory, in its own environment; see `timed.print_timed`.

From boxes in memory by frame, with ids already numbered from 0: overlaps, CLEAR, identity, HOTA.
Its reading and preparing of a sequence, which takes longer than that, is left out.
"""

import warnings

import numpy as np
from sequences import by_frame
from timed import print_timed

warnings.simplefilter("ignore")

from trackeval.datasets import MotChallenge2DBox  # noqa: E402
from trackeval.metrics import CLEAR, HOTA, Identity  # noqa: E402


def side(rows, frames):
    """A side by frame: numbers from 0, boxes counted from pixel 1."""
    rows[:, 1] = np.unique(rows[:, 1], return_inverse=True)[1]
    parts = by_frame(rows, frames)
    ids = [part[:, 1].astype(int) for part in parts]
    return ids, [part[:, 2:6] + [1.0, 1.0, 0.0, 0.0] for part in parts], int(rows[:, 1].max()) + 1


def prepare(truth, result):
    """Both sides, and the metrics."""
    frames = 1 + int(max(truth[-1, 0], result[-1, 0]))
    people, boxes, people_count = side(truth, frames)
    tracks, found, track_count = side(result, frames)
    data = {"num_timesteps": frames, "gt_ids": people, "tracker_ids": tracks}
    data |= {"num_gt_ids": people_count, "num_tracker_ids": track_count}
    data |= {"num_gt_dets": len(truth), "num_tracker_dets": len(result)}
    config = {"PRINT_CONFIG": False, "THRESHOLD": 0.5}
    metrics = [CLEAR(config), Identity(config), HOTA()]

    def measure():
        ious, told = MotChallenge2DBox._calculate_box_ious, {}
        pairs = zip(boxes, found, strict=True)
        whole = data | {"similarity_scores": [ious(a, b) for a, b in pairs]}
        for metric in metrics:
            told |= metric.eval_sequence(whole)
        return [np.mean(told[name]) for name in ("MOTA", "IDF1", "HOTA")]

    return measure


if __name__ == "__main__":
    print_timed(prepare)
