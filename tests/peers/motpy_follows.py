"""motpy over detections, in its own environment; see `following.main`.

It follows boxes: squares on the floor around the people's places, in metres. Its filter's
variances are given for metres and seconds, its size's are next to nothing.
"""

import numpy as np
from following import main
from motpy import Detection, MultiObjectTracker


def motpy(settings, fps):
    """Constant velocity and size; matched by overlap."""
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


if __name__ == "__main__":
    main({"motpy": motpy})
