"""Runs looked over as a whole: one id for each person, however often they were lost."""

from tracking.trackers.linking.linked import linked

__all__ = ["linked"]
