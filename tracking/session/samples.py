"""A session's part labels with what the tracker saw: samples of the failure detector."""

from __future__ import annotations

import logging
from collections.abc import Callable

from tracking.failure import Samples, no_samples, samples_of
from tracking.session.belonging import parts_by_now
from tracking.tracks import Labels, Run, TrackTable
from tracking.tracks.part_labels import PartLabels

_log = logging.getLogger(__name__)


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


class KeptSamples:
    """The samples a session's file has beside its labels, for those who read the file alone.

    They can be made again at any time, so no save waits for them longer than it must, and none
    fails for them: they are made anew only where the part labels or the corrected table are others
    than at the save before, and where they cannot be made the file has none.
    """

    def __init__(self) -> None:
        self._labels = PartLabels()
        self._revision = -1
        self._samples = no_samples()

    def of(
        self,
        labels: Labels,
        tracks: TrackTable,
        run: Callable[[], Run | None],
        recording: tuple[float, str],
    ) -> Samples:
        """The samples of a session's state; errors are logged.

        Args:
            tracks: the session's table, or a snapshot of it.
            run: gives the run the tracks began as, always the same; it is asked only for samples
                that must be made.
            recording: its fps and name.
        """
        if not len(labels.parts):
            return no_samples()
        if labels.parts is self._labels and tracks.revision == self._revision:
            return self._samples
        try:
            samples = samples_from(labels, tracks, run(), *recording)
        except Exception:
            _log.exception("samples of the part labels could not be made; the file has none")
            return no_samples()
        self._labels, self._revision, self._samples = labels.parts, tracks.revision, samples
        return samples
