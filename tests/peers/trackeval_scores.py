"""TrackEval's figures: `trackeval_scores.py SEQUENCES FIGURES`, in TrackEval's environment.

Every sequence is handed to TrackEval's own preparation of MOTChallenge sequences and to its
metrics with their default settings, don't-cares as distractors. Rows are matched by boxes and,
in a second run, by distance on the floor. Track-mAP is given the tracks as its TAO data set does.
"""

import json
import math
import sys
import warnings
from pathlib import Path

import numpy as np
from sequences import by_frame, read_sequences

warnings.simplefilter("ignore")

from trackeval.datasets import MotChallenge2DBox  # noqa: E402
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
    """The tracks for Track-mAP, as the TAO data set makes them."""
    found = {"iou_type": "bbox"}
    for side, sources in (("gt", "gt"), ("dt", "tracker")):
        tracks, confidences = {}, {}
        rows = zip(data[f"{sources}_ids"], data[f"{sources}_dets"], strict=True)
        for frame, (ids, dets) in enumerate(rows):
            for number, box in zip(ids.tolist(), dets, strict=True):
                tracks.setdefault(number, {})[frame] = box
                if side == "dt":
                    at = data["tracker_ids"][frame].tolist().index(number)
                    confidences.setdefault(number, []).append(
                        data["tracker_confidences"][frame][at]
                    )
        order = sorted(tracks)
        if side == "dt":
            scores = {number: float(np.mean(confidences[number])) for number in order}
            order = sorted(order, key=lambda number: -scores[number])
            found["dt_track_scores"] = [scores[number] for number in order]
        found[f"{side}_tracks"] = [tracks[number] for number in order]
        found[f"{side}_track_ids"] = [number + 1 for number in order]
        found[f"{side}_track_lengths"] = [len(tracks[number]) for number in order]
        found[f"{side}_track_areas"] = [
            sum(box[2] * box[3] for box in tracks[number].values()) / len(tracks[number])
            for number in order
        ]
    return found


def measured(metrics, data):
    """Each metric's own result of a sequence."""
    return {name: metric.eval_sequence(data) for name, metric in metrics.items()}


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


def main():
    """Measure every sequence and all of them combined."""
    sequences = read_sequences(sys.argv[1])
    made = dataset()
    quiet = {"PRINT_CONFIG": False}
    clear = {"CLEAR": CLEAR(dict(quiet, THRESHOLD=0.5))}
    clear |= {"Identity": Identity(dict(quiet, THRESHOLD=0.5)), "HOTA": HOTA(), "Count": Count()}
    told = {"box": {}, "floor": {}}
    for way, floor in (("box", False), ("floor", True)):
        metrics = dict(clear) if floor else {**clear, "TrackMAP": TrackMAP(dict(quiet))}
        results = {}
        for name, (truth, result) in sequences.items():
            data = made.get_preprocessed_seq_data(raw(made, truth, result, floor), "pedestrian")
            results[name] = measured(metrics, {**data, **({} if floor else whole_tracks(data))})
            one = {"TrackMAP": {name: results[name]["TrackMAP"]}} if not floor else {}
            for metric, parts in one.items():
                # A sequence's own Track-mAP is that of a set with one sequence.
                results[name][f"{metric} alone"] = metrics[metric].combine_sequences(parts)
        for name, found in results.items():
            alone = dict(found)
            if not floor:
                alone["TrackMAP"] = found["TrackMAP alone"]
            told[way][name] = figures(metrics, alone)
        combined = {
            name: metric.combine_sequences({seq: found[name] for seq, found in results.items()})
            for name, metric in metrics.items()
        }
        told[way]["COMBINED_SEQ"] = figures(metrics, combined)
    Path(sys.argv[2]).write_text(json.dumps(told), encoding="utf-8")


if __name__ == "__main__":
    main()
