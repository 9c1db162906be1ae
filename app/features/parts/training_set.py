"""What a detector learns from: the labels of sessions and exported samples, and where they are."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.core.i18n import count_text
from tracking.errors import SessionError, TrainingError
from tracking.failure import (
    Samples,
    joined,
    labels_from_truth,
    no_samples,
    people_followed,
    samples_of,
    told_apart,
)
from tracking.formats import samples_at
from tracking.recording import Recording
from tracking.session import (
    Session,
    boxes_of,
    places_of,
    samples_with_boxes,
)
from tracking.trackers import body_part_tracker
from tracking.tracks import Box, Labels, Run, TrackTable
from tracking.truth import TRUE_PARTS, read_true_parts


@dataclass(frozen=True, slots=True, eq=False)
class Source:
    """Where labels come from: a session, or a table of samples.

    Attributes:
        title: for people. path: of the file; None for the open session. samples: its labels.
        footage: tells recordings of one name apart; "" for a table.
        recording: its name; "" for a table, which names its own. fps: 0: not known.
        boxes: (n, 4) the rectangle that each sample judges, see `boxes_of`; None for a table.
    """

    title: str
    path: Path | None
    samples: Samples
    footage: str
    recording: str = ""
    fps: float = 0.0
    boxes: NDArray[np.float64] | None = None

    @property
    def said(self) -> str:
        """The source in words."""
        words = count_text(len(self.samples), "{n} sample", "{n} samples")
        return f"{self.title}: {words}"


@dataclass(frozen=True, slots=True, eq=False)
class TrainingSet:
    """What a detector learns from.

    Attributes:
        samples: of all `sources`, one source's after the other's.
    """

    samples: Samples
    sources: tuple[Source, ...]

    def source_of(self, sample: int) -> Source:
        """Where a row of the samples comes from."""
        return self.sources[self._place_of(sample)[0]]

    def box_of(self, sample: int) -> Box | None:
        """The rectangle that a row of the samples judges; None where its source does not say."""
        number, row = self._place_of(sample)
        boxes = self.sources[number].boxes
        return None if boxes is None else box_or_none(boxes[row])

    def _place_of(self, sample: int) -> tuple[int, int]:
        """The source of a row and which of the source's rows it is."""
        ends = np.cumsum([len(one.samples) for one in self.sources])
        number = int(np.searchsorted(ends, sample, "right"))
        return number, sample - int(ends[number]) + len(self.sources[number].samples)


def box_or_none(box: NDArray[np.float64]) -> Box | None:
    """A rectangle (4,); None where it is not known (NaN)."""
    left, top, width, height = box.tolist()
    return (left, top, width, height) if np.isfinite(box).all() else None


def build_training_set(sources: Sequence[Source]) -> TrainingSet:
    """The samples of several sources, different recordings under different names."""
    apart = told_apart(
        (one.samples, one.footage, one.path.stem if one.path is not None else one.title)
        for one in sources
    )
    return TrainingSet(joined(apart), tuple(sources))


def source_at(path: Path, *, from_truth: bool = False, allow_outside: bool = False) -> Source:
    """The labels of a session file, or samples that were exported from one (CSV or HDF5).

    Nothing of the session is claimed: whoever has it open goes on.

    Args:
        from_truth: labels are made from the truth beside the session's recording instead.
        allow_outside: for this, a recording outside of the session's folder may be opened.

    Raises SessionError or FormatError where it is neither or cannot be read, TrainingError where
    no parts were tracked or labels cannot be made from truth, RecordingMissing.
    """
    if path.is_dir():
        raise SessionError("{path}: this is a folder; name a session file", path=path)
    exported = samples_at(path)
    if exported is not None:
        if from_truth:
            raise TrainingError(
                "{path} holds samples: ground truth belongs to sessions; leave --from-truth out",
                path=path,
            )
        return Source(path.name, path, exported, "")
    with closing(Session.look_into(path)) as session:
        run = session.corrected_run
        if run is None or not len(run.parts.get("frame", ())):
            raise TrainingError(
                "{path}: its tracks have no body parts; track it with {tracker} first",
                path=path,
                tracker=body_part_tracker(),
            )
        if not from_truth:
            seen, title = session.recording, f"{session.recording.name} ({path.name})"
            source = Source(title, path, no_samples(), seen.footage, seen.name, seen.fps)
            return with_labels(source, session.labels, session.tracks, run)
        with session.open_recording(allow_outside=allow_outside) as recording:
            return _true_source(path, run, recording, session.recording.footage)


def with_labels(source: Source, labels: Labels, tracks: TrackTable, run: Run | None) -> Source:
    """The source with what labels teach that people gave, and the run the tracks began as."""
    samples, boxes = samples_with_boxes(labels, tracks, run, source.fps, source.recording)
    return replace(source, samples=samples, boxes=boxes)


def _true_source(path: Path, run: Run, recording: Recording, footage: str) -> Source:
    """Labels of the run as it was made, by the truth beside its recording; who each track is."""
    truth = recording.folder / TRUE_PARTS
    if not truth.is_file():
        raise TrainingError(
            "{path}: beside its recording is no {file}; label by hand", path=path, file=TRUE_PARTS
        )
    true, fps = read_true_parts(truth), recording.fps
    labels = labels_from_truth(true, run.parts, fps)
    people = people_followed(true, run.parts, fps)
    samples = samples_of(labels, run.parts, fps, recording.name, people)
    boxes = boxes_of(places_of(samples), {label.key: label for label in labels}, run.parts)
    title = f"{recording.name} ({path.name})"
    return Source(title, path, samples, footage, recording.name, fps, boxes)
