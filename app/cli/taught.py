"""Samples from whatever `train` is pointed at: sessions, and samples as CSV."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from app.cli.tracks import is_session
from tracking.errors import TrainingError
from tracking.failure import (
    TRUE_PARTS,
    Samples,
    labels_from_truth,
    read_true_parts,
    samples_of,
)
from tracking.formats import read_samples
from tracking.session import Session, samples_from
from tracking.tracks import Columns, PartKey, PartLabel


@dataclass(frozen=True, slots=True)
class How:
    """How labels are come by.

    Attributes:
        from_truth: they are made from the truth beside rendered recordings.
        allow_outside: a recording outside of its session's folder may be opened.
    """

    from_truth: bool = False
    allow_outside: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Taught:
    """Samples of one recording and where they come from.

    Attributes:
        path: the session, or the table of samples.
        name: of the recording. identity: tells recordings of one name apart.
        labels: by frame, track and part; none for a table.
    """

    path: Path
    name: str
    identity: str
    samples: Samples
    labels: Mapping[PartKey, PartLabel]

    def renamed(self) -> Taught:
        """The same, of a recording that bears the session's name too."""
        name = f"{self.name} ({self.path.stem})"
        recording = np.full(len(self.samples), name, object)
        columns = {**self.samples.columns, "recording": recording}
        return replace(self, name=name, samples=Samples(columns, self.samples.features))


def told_apart(taught: Sequence[Taught]) -> list[Taught]:
    """The same, where different recordings of one name bear the session's name too.

    Two sessions of one recording keep its name: their people are the same people.
    """
    first: dict[str, str] = {}
    for one in taught:
        first.setdefault(one.name, one.identity)
    return [one if first[one.name] == one.identity else one.renamed() for one in taught]


def taught_by(path: Path, how: How) -> Taught:
    """The samples of a session or a table of them.

    Raises what reading raises, and TrainingError where labels cannot be made from truth.
    """
    if not is_session(path):
        if how.from_truth:
            raise TrainingError(f"{path} is a table of samples: truth belongs to sessions")
        return Taught(path, str(path), str(path), read_samples(path), {})
    with closing(Session.open(path)) as session:
        adopted = session.adopted_run
        run = session.runs[adopted] if adopted is not None else None
        recording = session.recording
        if run is None or not len(run.parts.get("frame", ())):
            raise TrainingError(
                f"{path}: its tracks have no body parts; track it with three-part first"
            )
        identity = " ".join(source.sha256 for source in recording.sources)
        if how.from_truth:
            labels = _true_labels(session, path, run.parts, how)
            samples = samples_of(labels, run.parts, recording.fps, recording.name)
            said: Mapping[PartKey, PartLabel] = {label.key: label for label in labels}
        else:
            samples = samples_from(
                session.labels, session.tracks, run, recording.fps, recording.name
            )
            said = session.labels.parts
        return Taught(path, recording.name, identity, samples, said)


def _true_labels(session: Session, path: Path, parts: Columns, how: How) -> list[PartLabel]:
    """Labels of the run as it was made, by the truth beside its recording."""
    with session.open_recording(allow_outside=how.allow_outside) as recording:
        truth = recording.folder / TRUE_PARTS
        if not truth.is_file():
            raise TrainingError(f"{path}: beside its recording is no {TRUE_PARTS}; label by hand")
        return labels_from_truth(read_true_parts(truth), parts, recording.fps)
