"""py-motmetrics' figures: `motmetrics_scores.py SEQUENCES FIGURES`, in its own environment.

Sequences are compared as its `eval_motchallenge` does it: don't-cares are left out of the truth
when it is read, rows are matched at an overlap of one half; in a second run by distance on the
floor, up to the radius. Sequences with an empty side are left out: it refuses them.
"""

import json
import math
import sys
import warnings
from pathlib import Path

import pandas as pd
from sequences import read_sequences

warnings.simplefilter("ignore")

import motmetrics as mm  # noqa: E402

RADIUS_M = 0.5
FIGURES = [
    *("num_objects", "num_predictions", "num_unique_objects"),
    *("num_matches", "num_switches", "num_detections", "num_false_positives", "num_misses"),
    *("num_fragmentations", "mostly_tracked", "partially_tracked", "mostly_lost"),
    *("mota", "motp", "precision", "recall", "idf1", "idp", "idr", "idtp", "idfp", "idfn"),
]


def table(rows):
    """A side as its reader of MOTChallenge files gives it, floor positions beside."""
    names = ["FrameId", "Id", "X", "Y", "Width", "Height", "floor_x", "floor_y", "Confidence"]
    made = pd.DataFrame(rows, columns=names)
    made[["FrameId", "Id"]] = made[["FrameId", "Id"]].astype(int)
    return made.set_index(["FrameId", "Id"])


def compared(truth, result, floor):
    """The accumulator of one sequence."""
    truth = truth[truth["Confidence"] >= 1]
    if floor:
        fields = ["floor_x", "floor_y"]
        return mm.utils.compare_to_groundtruth(truth, result, "euc", fields, RADIUS_M)
    return mm.utils.compare_to_groundtruth(truth, result, "iou", distth=0.5)


def main():
    """Measure every sequence, and all of them together."""
    sequences = read_sequences(sys.argv[1])
    told = {}
    for way, floor in (("box", False), ("floor", True)):
        names, found = [], []
        for name, (truth, result) in sequences.items():
            if (truth[:, 8] >= 1).any() and len(result):
                names.append(name)
                found.append(compared(table(truth), table(result), floor))
        summary = mm.metrics.create().compute_many(
            found, names=names, metrics=FIGURES, generate_overall=True
        )
        told[way] = {
            str(name): {figure: plain(row[figure]) for figure in FIGURES}
            for name, row in summary.iterrows()
        }
    Path(sys.argv[2]).write_text(json.dumps(told), encoding="utf-8")


def plain(value):
    """A number; None where it is undefined."""
    number = float(value)
    return number if math.isfinite(number) else None


if __name__ == "__main__":
    main()
