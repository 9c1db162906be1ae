"""The timeline: a lane a track, and an overview of the whole recording."""

from app.views.timeline.view import TimelineView

__all__ = ["TimelineView"]
