"""A tracker over a recording, frame by frame, and what it finds kept in little memory."""

from tracking.pipeline.run_buffer import KeptSteps, run_of_steps
from tracking.pipeline.tracking_loop import Tracking, background_samples, begin_pairing, track
