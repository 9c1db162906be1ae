"""Our own stereo tracker: everybody's best explanation of a frame at once."""

from tracking.trackers.joint.building import build_joint
from tracking.trackers.joint.settings import JointSettings

__all__ = ["JointSettings", "build_joint"]
