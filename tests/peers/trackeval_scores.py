"""TrackEval's figures: `trackeval_scores.py SEQUENCES|mot|kitti FOLDER...`, in its environment.

Every sequence is handed to TrackEval's own preparation of MOTChallenge sequences and to its
metrics with their default settings, don't-cares as distractors. Rows are matched by boxes and,
in a second run, by distance on the floor. Track-mAP is given the tracks as its TAO data set does.
Text files are read by TrackEval's own data sets.
"""

import contextlib
import io
import json
import math
import sys
import warnings
from pathlib import Path

import numpy as np
from sequences import by_frame, read_tables

warnings.simplefilter("ignore")

from trackeval.datasets import Kitti2DBox, MotChallenge2DBox  # noqa: E402
from trackeval.metrics import CLEAR, HOTA, Count, Identity, TrackMAP  # noqa: E402

RADIUS_M = 0.5
PEDESTRIAN, DISTRACTOR = 1, 8


def dataset():
    """TrackEval's data set without its files."""
    made = MotChallenge2DBox.__new__(MotChallenge2DBox)
    made.benchmark, made.do_preproc = "MOT17", True
    made.class_name_to_class_id = {
        "pedestrian": 1, "person_on_vehicle": 2, "car": 3, "bicycle": 4, "motorbike": 5,
        "non_mot_vehicle": 6, "static_person": 7, "distractor": 8, "occluder": 9,
        "occluder_on_ground": 10, "occluder_full": 11, "reflection": 12, "crowd": 13,
    }  # fmt: skip
    made.valid_class_numbers = list(made.class_name_to_class_id.values())
    return made


def raw(made, truth, result, floor):
    """A sequence as the data set reads it from its files."""
    frames = 1 + int(max([-1.0, *truth[:, 0], *result[:, 0]]))
    data = {"num_timesteps": frames, "seq": "sequence"}
    truths, results = by_frame(truth, frames), by_frame(result, frames)
    counted = [rows[:, 8] != 0 for rows in truths]
    data["gt_ids"] = [rows[:, 1].astype(int) for rows in truths]
    # Only Track-mAP looks at these: counted from pixel 0, as in the files of TAO.
    data["gt_dets"] = [rows[:, 2:6] for rows in truths]
    data["gt_classes"] = [np.where(one, PEDESTRIAN, DISTRACTOR) for one in counted]
    data["gt_extras"] = [{"zero_marked": one.astype(int)} for one in counted]
    data["tracker_ids"] = [rows[:, 1].astype(int) for rows in results]
    data["tracker_dets"] = [rows[:, 2:6] for rows in results]
    data["tracker_classes"] = [np.ones(len(rows), int) for rows in results]
    data["tracker_confidences"] = [rows[:, 8] for rows in results]
    both = zip(truths, results, strict=True)
    if floor:
        data["similarity_scores"] = [
            made._calculate_euclidean_similarity(a[:, 6:8], b[:, 6:8], 2 * RADIUS_M)
            for a, b in both
        ]
    else:
        data["similarity_scores"] = [made._calculate_box_ious(boxes(a), boxes(b)) for a, b in both]
    return data


def boxes(rows):
    """(n, 4) counted from pixel 1, as in MOTChallenge's files."""
    return rows[:, 2:6] + [1.0, 1.0, 0.0, 0.0]


def whole_tracks(data):
    """The tracks for Track-mAP, as the TAO data set makes them; the surest results come first."""
    found = {"iou_type": "bbox"}
    for side, source in (("gt", "gt"), ("dt", "tracker")):
        tracks, sure = {}, {}
        for frame, (ids, dets) in enumerate(
            zip(data[f"{source}_ids"], data[f"{source}_dets"], strict=True)
        ):
            for at, number in enumerate(ids.tolist()):
                tracks.setdefault(number, {})[frame] = dets[at]
                if side == "dt":
                    sure.setdefault(number, []).append(data["tracker_confidences"][frame][at])
        scores = {number: float(np.mean(each)) for number, each in sure.items()}
        order = sorted(tracks, key=lambda number: (-scores.get(number, 0.0), number))
        found[f"{side}_tracks"] = [tracks[number] for number in order]
        found[f"{side}_track_ids"] = [number + 1 for number in order]
        found[f"{side}_track_lengths"] = [len(tracks[number]) for number in order]
        found[f"{side}_track_areas"] = [
            sum(box[2] * box[3] for box in tracks[number].values()) / len(tracks[number])
            for number in order
        ]
        if side == "dt":
            found["dt_track_scores"] = [scores[number] for number in order]
    return found


def plain(value):
    """Numbers and lists; -1 of Track-mAP, which means undefined, stays."""
    if isinstance(value, (list, np.ndarray)):
        return [plain(one) for one in np.asarray(value).tolist()]
    number = float(value)
    return number if math.isfinite(number) else None


def figures(metrics, results):
    """The fields of every metric by name."""
    return {
        f"{name}.{field}": plain(results[name][field])
        for name, metric in metrics.items()
        for field in metric.fields
    }


def of_sequences(sequences, floor):
    """Figures of every sequence and of all of them combined."""
    metrics, made, results = metrics_of(floor), dataset(), {}
    for name, (truth, result) in sequences.items():
        data = made.get_preprocessed_seq_data(raw(made, truth, result, floor), "pedestrian")
        data |= {} if floor else whole_tracks(data)
        results[name] = {one: metric.eval_sequence(data) for one, metric in metrics.items()}
    told = {
        name: figures(metrics, with_track_map(metrics, found)) for name, found in results.items()
    }
    combined = {
        one: metric.combine_sequences({name: found[one] for name, found in results.items()})
        for one, metric in metrics.items()
    }
    return told | {"COMBINED_SEQ": figures(metrics, combined)}


def metrics_of(floor):
    """The metrics by name."""
    quiet = {"PRINT_CONFIG": False, "THRESHOLD": 0.5}
    found = {"CLEAR": CLEAR(quiet), "Identity": Identity(quiet), "HOTA": HOTA(), "Count": Count()}
    return found if floor else found | {"TrackMAP": TrackMAP({"PRINT_CONFIG": False})}


def with_track_map(metrics, found):
    """A sequence's own Track-mAP is that of a set with one sequence."""
    if "TrackMAP" not in metrics:
        return found
    return found | {"TrackMAP": metrics["TrackMAP"].combine_sequences({"": found["TrackMAP"]})}


def of_files(kind, folder):
    """Figures of the sequence in a folder's `truth` and `trackers/ours`."""
    places = {"GT_FOLDER": f"{folder}/truth", "TRACKERS_FOLDER": f"{folder}/trackers"}
    config = {**places, "TRACKERS_TO_EVAL": ["ours"], "PRINT_CONFIG": False}
    with contextlib.redirect_stdout(io.StringIO()):
        if kind == "kitti":
            made, name = Kitti2DBox(config), "0000"
        else:
            benchmark, name = Path(folder, "benchmark").read_text(), "lobby"
            config |= {"BENCHMARK": benchmark, "SKIP_SPLIT_FOL": True, "SEQ_INFO": {name: None}}
            made = MotChallenge2DBox(config)
        data = made.get_preprocessed_seq_data(made.get_raw_seq_data("ours", name), "pedestrian")
        metrics = metrics_of(floor=True)
        return figures(metrics, {one: each.eval_sequence(data) for one, each in metrics.items()})


if __name__ == "__main__":
    if sys.argv[1] in ("mot", "kitti"):
        print(json.dumps([of_files(sys.argv[1], folder) for folder in sys.argv[2:]]))
    else:
        sequences = read_tables(sys.argv[1])
        print(
            json.dumps(
                {"box": of_sequences(sequences, False), "floor": of_sequences(sequences, True)}
            )
        )
