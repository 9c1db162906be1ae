"""py-motmetrics' figures: `motmetrics_scores.py SEQUENCES|mot FOLDER...`, in its own environment.

Sequences are compared as its `eval_motchallenge` does it: don't-cares are left out of the truth
when it is read, rows are matched at an overlap of one half; in a second run by distance on the
floor, up to the radius. Sequences with an empty side are left out: it refuses them. Text files are
read by its own reader.
"""

import json
import math
import sys
import warnings

import pandas as pd
from sequences import read_tables

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


def measured(names, found):
    """The figures of each sequence by its name, and of all of them together."""
    summary = mm.metrics.create().compute_many(
        found, names=names, metrics=FIGURES, generate_overall=True
    )
    return {
        str(name): {figure: plain(row[figure]) for figure in FIGURES}
        for name, row in summary.iterrows()
    }


def of_sequences(sequences, floor):
    """Figures of the sequences it does not refuse."""
    counted = {
        name: pair
        for name, pair in sequences.items()
        if (pair[0][:, 8] >= 1).any() and len(pair[1])
    }
    pairs = [[table(side) for side in pair] for pair in counted.values()]
    return measured(list(counted), [compared(*pair, floor) for pair in pairs])


def of_files(folder):
    """Figures of the sequence in a folder's `truth` and `trackers/ours`."""
    truth = mm.io.loadtxt(f"{folder}/truth/lobby/gt/gt.txt", min_confidence=1)
    ours = mm.io.loadtxt(f"{folder}/trackers/ours/data/lobby.txt")
    return measured(["lobby"], [compared(truth, ours, False)])["lobby"]


def plain(value):
    """A number; None where it is undefined."""
    number = float(value)
    return number if math.isfinite(number) else None


if __name__ == "__main__":
    if sys.argv[1] == "mot":
        print(json.dumps([of_files(folder) for folder in sys.argv[2:]]))
    else:
        sequences = read_tables(sys.argv[1])
        told = {way: of_sequences(sequences, way == "floor") for way in ("box", "floor")}
        print(json.dumps(told))
