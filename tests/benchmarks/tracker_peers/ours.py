"""Our stereo trackers over the same detections as the trackers of others."""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.tracker_peers.clips import Clip
from tests.peers.followers import Followed
from tracking.pipeline import run_of_steps
from tracking.recording import open_recording
from tracking.settings import settings_values
from tracking.trackers import StepResult, tracker_named
from tracking.tracks import Columns

_SEED = 0


def follow(tracker: str, clip: Clip) -> tuple[Followed, Followed]:
    """Its rows as frames came, and of the run looked over as a whole, with its own settings.

    The times of the second are the first's and, shared out evenly, that of looking it over.
    """
    spec = tracker_named(tracker)
    settings = spec.settings_type()
    with open_recording(clip.recording) as recording:
        _, following = spec.build(recording, settings, _SEED)
        steps, taken = [], []
        for observation in clip.observations:
            begun = time.process_time()
            steps.append(following.step(observation))
            taken.append(time.process_time() - begun)
        online_s, begun = np.array(taken), time.process_time()
        run = run_of_steps(steps, spec.name, settings_values(settings), _SEED, 0, recording)
        finished_s = online_s + (time.process_time() - begun) / len(steps)
    return (_joined(steps), online_s), (_rows(run.tracks), finished_s)


def _joined(steps: Sequence[StepResult]) -> NDArray[np.float64]:
    return np.concatenate([_rows(step.tracks) for step in steps])


def _rows(tracks: Columns) -> NDArray[np.float64]:
    """(n, 4) by `tests.peers.peer_runs.FOLLOWED`."""
    return np.column_stack([tracks[name] for name in ("frame", "track", "x", "y")])
