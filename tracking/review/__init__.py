"""Where to look: places where tracks are likely wrong, ranked by what looking is worth."""

from tracking.review.measures import Mistake, ReviewMeasures, ReviewMeter, review_measures
from tracking.review.queue import open_suspicions, ranked
from tracking.review.reason_phrases import KINDS
from tracking.review.review_search import Lookout, find_suspicions
from tracking.review.suspicion import Suspicion, SuspicionKey

__all__ = [
    "KINDS",
    "Lookout",
    "Mistake",
    "ReviewMeasures",
    "ReviewMeter",
    "Suspicion",
    "SuspicionKey",
    "find_suspicions",
    "open_suspicions",
    "ranked",
    "review_measures",
]
