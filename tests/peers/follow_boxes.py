"""Boxes of a detector followed by trackers of others, as they come, in the environment `trackers`.

`follow_boxes.py DETECTIONS RESULTS`: {name: (frames, frames a second, (n, 6) of `SEEN`)} there,
{tracker: {name: (n, 6) of `FOLLOWED`}} here.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))

from sequences import by_frame, read_tables, write_tables

SEEN = ("frame", "left", "top", "width", "height", "confidence")
FOLLOWED = ("frame", "track", "left", "top", "width", "height")
NAMES = {
    "SORT": "SORTTracker",
    "ByteTrack": "ByteTrackTracker",
    "OC-SORT": "OCSORTTracker",
    "BoT-SORT": "BoTSORTTracker",
}


def follow(kind, frames, fps, seen):
    """(n, 6) rows of one tracker with its own defaults, without pictures."""
    import supervision
    import trackers

    own = {"enable_cmc": False} if kind == "BoTSORTTracker" else {}
    tracker = getattr(trackers, kind)(frame_rate=fps, **own)
    rows = []
    for frame, given in enumerate(by_frame(seen, frames)):
        corners = np.hstack([given[:, 1:3], given[:, 1:3] + given[:, 3:5]]).astype(np.float32)
        number = np.zeros(len(given), int)
        boxes = supervision.Detections(xyxy=corners, confidence=given[:, 5], class_id=number)
        told = tracker.update(boxes)
        for track, (left, top, right, bottom) in zip(told.tracker_id, told.xyxy, strict=True):
            if track >= 0:
                rows.append((frame, track + 1, left, top, right - left, bottom - top))
    return np.array(rows, float).reshape(-1, len(FOLLOWED))


if __name__ == "__main__":
    sequences = read_tables(sys.argv[1])
    followed = {
        name: {clip: follow(kind, *given) for clip, given in sequences.items()}
        for name, kind in NAMES.items()
    }
    write_tables(sys.argv[2], followed)
