"""What scorers make of text files: `text_files.py mot|kitti|motmetrics FOLDER...`, as JSON.

A folder holds `truth` and `ours` as the scorer wants them. Each runs in its own environment.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys
import warnings
from pathlib import Path

warnings.simplefilter("ignore")
FIELDS = {
    "CLEAR": ("CLR_TP", "CLR_FN", "CLR_FP", "IDSW", "Frag", "MOTA", "MOTP"),
    "Identity": ("IDTP", "IDF1"),
    "HOTA": ("HOTA", "DetA", "AssA"),
}


def trackeval(kind, folder):
    """Figures of one sequence, read by TrackEval's own data set for such files."""
    from trackeval import datasets, metrics

    places = {"GT_FOLDER": f"{folder}/truth", "TRACKERS_FOLDER": f"{folder}/trackers"}
    config = {**places, "TRACKERS_TO_EVAL": ["ours"], "PRINT_CONFIG": False}
    with contextlib.redirect_stdout(io.StringIO()):
        if kind == "kitti":
            made = datasets.Kitti2DBox(config)
        else:
            benchmark = Path(folder, "benchmark").read_text()
            config |= {"BENCHMARK": benchmark, "SKIP_SPLIT_FOL": True, "SEQ_INFO": {"lobby": None}}
            made = datasets.MotChallenge2DBox(config)
        name = "0000" if kind == "kitti" else "lobby"
        data = made.get_preprocessed_seq_data(made.get_raw_seq_data("ours", name), "pedestrian")
        quiet = {"PRINT_CONFIG": False}
        found = {
            "CLEAR": metrics.CLEAR(quiet).eval_sequence(data),
            "Identity": metrics.Identity(quiet).eval_sequence(data),
            "HOTA": metrics.HOTA().eval_sequence(data),
        }
    return {
        f"{metric}.{field}": found[metric][field].tolist()
        if metric == "HOTA"
        else float(found[metric][field])
        for metric, fields in FIELDS.items()
        for field in fields
    }


def motmetrics(folder):
    """Figures of one sequence, read by py-motmetrics."""
    import motmetrics as mm

    truth = mm.io.loadtxt(f"{folder}/truth/lobby/gt/gt.txt", min_confidence=1)
    ours = mm.io.loadtxt(f"{folder}/trackers/ours/data/lobby.txt")
    told = mm.utils.compare_to_groundtruth(truth, ours, "iou", distth=0.5)
    names = ["num_matches", "num_switches", "num_misses", "num_false_positives", "mota", "idf1"]
    summary = mm.metrics.create().compute(told, metrics=names, name="lobby")
    return {name: float(summary[name]["lobby"]) for name in names}


def main():
    """Say what is made of each folder."""
    kind, *folders = sys.argv[1:]
    if kind == "motmetrics":
        print(json.dumps([motmetrics(folder) for folder in folders]))
    else:
        print(json.dumps([trackeval(kind, folder) for folder in folders]))


if __name__ == "__main__":
    main()
