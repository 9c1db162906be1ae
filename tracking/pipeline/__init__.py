"""A tracker over a recording, frame by frame, and what it finds kept in little memory."""

from tracking.pipeline.tracking import Tracking, background_samples, run_of_steps, track

__all__ = ["Tracking", "background_samples", "run_of_steps", "track"]
