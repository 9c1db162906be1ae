"""Bags of ROS 1 and ROS 2, and MCAP files."""

from __future__ import annotations

from pathlib import Path

from tracking.recording.bags.bag_pictures import calibration_texts, is_bag, open_bag
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.translation import N_


def find_bag(path: Path) -> FoundSources | None:
    """The cameras of a bag; None: it is none.

    Raises:
        RecordingError: it cannot be read, or holds no images.
    """
    if not is_bag(path):
        return None
    contents = open_bag(path).contents
    return FoundSources(
        path,
        path if contents.topics[1] else None,
        path if contents.topics[2] else None,
        calibration=(path,) if calibration_texts(contents) else (),
        topics=("", "", ""),
        name=path.stem,
    )


BAG = RecordingKind(
    "bag", N_("rosbag 1 and 2 and MCAP: images, compressed images, depth, camera_info"), find_bag
)
