"""norfair over detections, in its own environment; see `following.main`.

It is given points on the floor in metres and compares them by Euclidean distance. Its filter's
deviations are of a position in metres and a velocity in metres a frame.
"""

import numpy as np
from following import main
from norfair import Detection, OptimizedKalmanFilterFactory, Tracker


def norfair(settings, fps):
    """Its own assignment by least distance, its optimised Kalman filter."""
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


if __name__ == "__main__":
    main({"norfair": norfair})
