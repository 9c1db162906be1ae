"""Work off the GUI thread: request, ticket, newest wins, progress, cancel.

Every class here owns one Python thread, reports by signals that arrive in the receiver's thread,
and waits for its thread in `close`.
"""

from app.background.frames import FrameReader
from app.background.jobs import Job, Progress
from app.background.live import LiveTracker
from app.background.newest import LatestJob
from app.background.overlays import OverlayMaker

__all__ = ["FrameReader", "Job", "LatestJob", "LiveTracker", "OverlayMaker", "Progress"]
