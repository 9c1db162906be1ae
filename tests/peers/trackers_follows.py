"""SORT, ByteTrack and OC-SORT of `trackers` over detections, in its own environment.

See `following.main`. They follow boxes in pixels: squares on the floor around the people's places
at so many pixels a metre, or the boxes in the picture. They give back the detections with ids, so
a row's place is the detection's. All detections are equally sure.
"""

import numpy as np
import supervision as sv
from following import main
from trackers import ByteTrackTracker, OCSORTTracker, SORTTracker
from trackers.utils.iou import DIoU, GIoU, IoU
from trackers.utils.state_representations import XCYCSRStateEstimator, XYXYStateEstimator

BUFFER_FPS = 30
"""The frame rate that the library counts its buffer of lost frames for, whatever the footage's."""
ESTIMATORS = {"corners": XYXYStateEstimator, "centre": XCYCSRStateEstimator}
OVERLAPS = {"iou": IoU, "giou": GIoU, "diou": DIoU}


def boxes_of(seen, settings):
    """(k, 4) left, top, right, bottom."""
    if settings["boxes"] == "picture":
        return np.hstack([seen[:, 1:3], seen[:, 1:3] + seen[:, 3:5]])
    middle, half = (
        seen[:, 5:7] * settings["px_per_m"],
        settings["px_per_m"] * settings["size_m"] / 2,
    )
    return np.hstack([middle - half, middle + half])


def started(kind, own):
    """How one of them is started; `own` are its settings that not all have."""

    def start(settings, fps):
        tracker = kind(
            lost_track_buffer=round(settings["lost_s"] * BUFFER_FPS),
            frame_rate=fps,
            minimum_consecutive_frames=settings["minimum_consecutive_frames"],
            minimum_iou_threshold=settings["minimum_iou"],
            state_estimator_class=ESTIMATORS[settings["state"]],
            iou=OVERLAPS[settings["overlap"]](),
            **{name: settings[name] for name in own},
        )

        def step(frame, seen):
            given = sv.Detections(xyxy=boxes_of(seen, settings), data={"place": seen[:, 5:7]})
            told = tracker.update(given)
            places = told.data["place"] if len(told) else ()
            for number, place in zip(told.tracker_id, places, strict=True):
                if number >= 0:
                    yield int(number), place

        return step

    return start


if __name__ == "__main__":
    main(
        {
            "SORT": started(SORTTracker, ()),
            "ByteTrack": started(ByteTrackTracker, ()),
            "OC-SORT": started(OCSORTTracker, ("direction_consistency_weight", "delta_t")),
        }
    )
