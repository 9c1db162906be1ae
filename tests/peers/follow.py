"""Trackers of others over detections, each in its own environment: `follow.py GIVEN TOLD ASKED`.

GIVEN holds clips, {name: (frames, frames a second, (n, 8) by `SEEN`, sorted by frame)}; ASKED is a
list of a tracker's name and its settings; TOLD gets what each makes of the clips. Each tracker is a
function of its settings and the frames a second; its library is imported when it starts.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from sequences import by_frame, read_tables, write_tables

SEEN = ("frame", "left", "top", "width", "height", "x", "y", "merged")
"""Of a detection; frames and pixels from 0, metres on the floor; 1 where a region may be several
people's."""
FOLLOWED = ("frame", "track", "x", "y")
"""Of a row that a tracker gives."""


def follow(start, seen, frames, fps, settings):
    """One tracker over one clip: rows and the seconds of processor time that each frame took.

    What it takes to set the tracker up is left out.

    Args:
        start: (settings, frames a second) -> a function that takes a frame's number and its
            detections (k, 8) and gives pairs of an id, anything hashable, and a place (x, y).
    """
    if not settings["with_merged"]:
        seen = seen[seen[:, 7] == 0]
    numbers, rows, taken = {}, [], []
    step = start(settings, fps)
    for frame, given in enumerate(by_frame(seen, frames)):
        begun = time.process_time()
        for name, (x, y) in step(frame, given):
            rows.append((frame, numbers.setdefault(name, len(numbers) + 1), float(x), float(y)))
        taken.append(time.process_time() - begun)
    return np.array(rows).reshape(-1, len(FOLLOWED)), np.array(taken)


def norfair(settings, fps):
    """Its own assignment by least distance between points in metres, its optimised Kalman filter.

    The filter's deviations are of a position in metres and a velocity in metres a frame.
    """
    from norfair import Detection, OptimizedKalmanFilterFactory, Tracker

    tracker = Tracker(
        distance_function="euclidean",
        distance_threshold=settings["distance_threshold_m"],
        hit_counter_max=settings["hit_counter_max"],
        initialization_delay=settings["initialization_delay"],
        filter_factory=OptimizedKalmanFilterFactory(
            R=settings["noise_m"] ** 2,
            Q=settings["process_m"] ** 2,
            pos_variance=settings["noise_m"] ** 2,
            vel_variance=(settings["speed_m_s"] / fps) ** 2,
        ),
        past_detections_length=0,
    )
    matched = {}

    def step(frame, seen):
        given = [Detection(points=place[None], data=frame) for place in seen[:, 5:7]]
        for one in tracker.update(given):
            if one.last_detection.data == frame:
                matched[one.id] = frame
            if frame - matched.get(one.id, -np.inf) <= settings["told_frames"]:
                yield one.id, one.estimate[0]

    return step


def motpy(settings, fps):
    """Squares on the floor of constant velocity and size, in metres, matched by overlap."""
    from motpy import Detection, MultiObjectTracker

    tracker = MultiObjectTracker(
        dt=1.0 / fps,
        model_spec={
            "order_pos": 1,
            "dim_pos": 2,
            "order_size": 0,
            "dim_size": 2,
            "q_var_pos": settings["acceleration_m_s2"] ** 2,
            "r_var_pos": settings["noise_m"] ** 2,
            "q_var_size": 1e-6,
            "r_var_size": 1e-4,
            "p_cov_p0": settings["start"] ** 2,
        },
        matching_fn_kwargs={"min_iou": settings["min_iou"]},
        tracker_kwargs={"max_staleness": settings["max_staleness"]},
        active_tracks_kwargs={
            "min_steps_alive": settings["min_steps_alive"],
            "max_staleness": settings["told_staleness"],
            "max_staleness_to_positive_ratio": settings["staleness_to_positive"],
        },
    )
    half = settings["size_m"] / 2

    def step(frame, seen):
        boxes = np.hstack([seen[:, 5:7] - half, seen[:, 5:7] + half])
        for one in tracker.step([Detection(box=box) for box in boxes]):
            yield one.id, (one.box[:2] + one.box[2:]) / 2

    return step


BUFFER_FPS = 30
"""The frame rate that `trackers` counts its buffer of lost frames for, whatever the footage's."""


def of_trackers(kind, *own):
    """How one of `trackers` is started; `own` are its settings that not all have.

    They follow boxes in pixels: squares on the floor at so many pixels a metre, or the boxes in the
    picture. They give back the detections with ids, so a row's place is the detection's. All
    detections are equally sure.
    """

    def start(settings, fps):
        import supervision
        import trackers
        from trackers.utils import iou, state_representations

        states = {
            "corners": state_representations.XYXYStateEstimator,
            "centre": state_representations.XCYCSRStateEstimator,
        }
        overlaps = {"iou": iou.IoU, "giou": iou.GIoU, "diou": iou.DIoU}
        tracker = getattr(trackers, kind)(
            lost_track_buffer=round(settings["lost_s"] * BUFFER_FPS),
            frame_rate=fps,
            minimum_consecutive_frames=settings["minimum_consecutive_frames"],
            minimum_iou_threshold=settings["minimum_iou"],
            state_estimator_class=states[settings["state"]],
            iou=overlaps[settings["overlap"]](),
            **{name: settings[name] for name in own},
        )

        def step(frame, seen):
            boxes, places = boxes_of(seen, settings), {"place": seen[:, 5:7]}
            told = tracker.update(supervision.Detections(xyxy=boxes, data=places))
            places = told.data["place"] if len(told) else ()
            for number, place in zip(told.tracker_id, places, strict=True):
                if number >= 0:
                    yield int(number), place

        return step

    return start


def boxes_of(seen, settings):
    """(k, 4) left, top, right, bottom."""
    if settings["boxes"] == "picture":
        return np.hstack([seen[:, 1:3], seen[:, 1:3] + seen[:, 3:5]])
    scale = settings["px_per_m"]
    middle, half = seen[:, 5:7] * scale, scale * settings["size_m"] / 2
    return np.hstack([middle - half, middle + half])


def of_stonesoup(kind):
    """How one of Stone Soup's is started."""

    def start(settings, fps):
        import stonesoup_trackers

        return getattr(stonesoup_trackers, kind)(settings, fps)

    return start


STARTS = {
    "norfair": norfair,
    "motpy": motpy,
    "SORT": of_trackers("SORTTracker"),
    "ByteTrack": of_trackers("ByteTrackTracker"),
    "OC-SORT": of_trackers("OCSORTTracker", "direction_consistency_weight", "delta_t"),
    "Stone Soup GNN": of_stonesoup("gnn"),
    "Stone Soup JPDA": of_stonesoup("jpda"),
}

if __name__ == "__main__":
    clips = read_tables(sys.argv[1])
    results = [
        {
            name: follow(STARTS[tracker], seen, frames, fps, settings)
            for name, (frames, fps, seen) in clips.items()
        }
        for tracker, settings in json.loads(sys.argv[3])
    ]
    write_tables(sys.argv[2], results)
