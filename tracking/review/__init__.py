"""Where to look: places where tracks are likely wrong, ranked by what looking is worth."""

from tracking.review.suspicion import Suspicion, SuspicionKey

__all__ = ["Suspicion", "SuspicionKey"]
