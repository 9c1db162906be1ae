"""A tracker in a process of its own, so that it never takes the interpreter from the window.

No Qt here: the child imports this package and nothing above it.
"""

from app.core.tracking_process.parent import TrackerProcess
from app.core.tracking_process.request import TrackingRequest

__all__ = ["TrackerProcess", "TrackingRequest"]
