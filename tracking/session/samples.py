"""A session's part labels with what the tracker saw: samples of the failure detector."""

from __future__ import annotations

from tracking.failure import Samples, no_samples, samples_of
from tracking.session.belonging import parts_by_now
from tracking.tracks import Labels, Run, TrackTable


def samples_from(
    labels: Labels, tracks: TrackTable, run: Run | None, fps: float, recording: str
) -> Samples:
    """The samples that labels give with the run the tracks began as; fps and name of the recording.

    No samples without labels, or where the run followed no parts.
    """
    if run is None or not len(labels.parts) or not len(run.parts["frame"]):
        return no_samples()
    people = {label.track for label in labels.parts.values()}
    parts = parts_by_now(tracks, run, people)
    return samples_of(labels.parts.values(), parts, fps, recording)
