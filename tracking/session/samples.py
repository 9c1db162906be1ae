"""A session's part labels with what the tracker saw: samples of the failure detector."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tracking.errors import TrackwrightError
from tracking.failure import Samples, no_samples, part_states, samples_of
from tracking.session.notes import tell_damage
from tracking.session.provenance import parts_by_now
from tracking.tracks import Columns, Labels, PartKey, PartLabel, Run, TrackTable
from tracking.tracks.part_labels import PartLabels
from tracking.translation import msg

_log = logging.getLogger(__name__)
_WITHOUT = "samples of the part labels could not be made; the file has none"

Boxes = NDArray[np.float64]


Place = tuple[PartKey, bool]
"""What a sample judges: a part, and whether it is said to be on it."""


def samples_from(
    labels: Labels, tracks: TrackTable, run: Run | None, fps: float, recording: str
) -> Samples:
    """The samples that labels give with the run the tracks began as; fps and name of the recording.

    No samples without labels, or where the run followed no parts.
    """
    parts = _parts_labelled(labels, tracks, run)
    return (
        no_samples() if parts is None else samples_of(labels.parts.values(), parts, fps, recording)
    )


def samples_with_boxes(
    labels: Labels, tracks: TrackTable, run: Run | None, fps: float, recording: str
) -> tuple[Samples, Boxes]:
    """The same, and the rectangle that each of them judges, see `boxes_of`."""
    parts = _parts_labelled(labels, tracks, run)
    if parts is None:
        return no_samples(), np.zeros((0, 4))
    samples = samples_of(labels.parts.values(), parts, fps, recording)
    return samples, boxes_of(places_of(samples), labels.parts, parts)


def places_of(samples: Samples) -> list[Place]:
    """What each sample judges."""
    columns = (samples.columns[name].tolist() for name in ("frame", "track", "part", "label"))
    return [
        ((frame, track, part), bool(on)) for frame, track, part, on in zip(*columns, strict=True)
    ]


def boxes_of(places: Sequence[Place], labels: Mapping[PartKey, PartLabel], parts: Columns) -> Boxes:
    """The rectangle of a label, or the tracker's where samples say the opposite of the label.

    They do where somebody put a part right: it is theirs that lies on the part.

    Args:
        labels: that the samples were made of. parts: `PART_COLUMNS` of the run they are of, under
            the ids of the labels.

    Returns:
        (n, 4) left, top, width, height px; NaN where neither is known any more.
    """
    boxes = np.full((len(places), 4), np.nan)
    tracked = []
    for row, (key, on) in enumerate(places):
        label = labels.get(key)
        if label is not None and label.on_part == on:
            boxes[row] = label.box
        else:
            tracked.append(row)
    if not tracked:
        return boxes
    frame, track, part = np.array([places[row][0] for row in tracked], np.int64).T
    seen = part_states(parts, 1.0)
    at = seen.rows_of(track, frame)
    known = at >= 0
    states = seen.states[at[known], part[known]]
    corners = states[:, :2] - states[:, 2:4] / 2
    boxes[np.array(tracked)[known]] = np.concatenate((corners, states[:, 2:4]), axis=1)
    return boxes


def _parts_labelled(labels: Labels, tracks: TrackTable, run: Run | None) -> Columns | None:
    """The parts of everybody labelled, under the ids of now; None where there are none."""
    if run is None or not len(labels.parts) or not len(run.parts["frame"]):
        return None
    return parts_by_now(tracks, run, {label.track for label in labels.parts.values()})


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
        """The samples of a session's state; a run that cannot be read is told.

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
        except TrackwrightError as error:
            tell_damage(
                msg(
                    "samples of the part labels could not be made; the file has none: {error}",
                    error=error,
                )
            )
            return no_samples()
        except Exception:
            _log.exception(_WITHOUT)
            return no_samples()
        self._labels, self._revision, self._samples = labels.parts, tracks.revision, samples
        return samples
