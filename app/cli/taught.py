"""Samples from whatever `train` is pointed at: sessions, and exported samples."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

from tracking.errors import TrainingError
from tracking.failure import (
    TRUE_PARTS,
    Samples,
    labels_from_truth,
    people_followed,
    read_true_parts,
    samples_of,
    told_apart,
)
from tracking.formats import samples_at
from tracking.recording import Recording
from tracking.session import RecordingMissing, Session, samples_from
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
        path: the session, or the file of samples.
        name: of the recording. footage: tells recordings of one name apart; "" for a table.
        labels: by frame, track and part; none for a table.
    """

    path: Path
    name: str
    footage: str
    samples: Samples
    labels: Mapping[PartKey, PartLabel]

    def named_by(self, samples: Samples) -> Taught:
        """The same, with the names that its recordings have among others."""
        names = samples.columns["recording"]
        return replace(self, name=str(names[0]) if len(names) else self.name, samples=samples)


def all_taught(paths: Sequence[Path], how: How) -> list[Taught]:
    """The samples of sessions and tables, different recordings under different names.

    Raises as `taught_by`.
    """
    taught = [taught_by(path, how) for path in paths]
    apart = told_apart((one.samples, one.footage, one.path.stem) for one in taught)
    return [one.named_by(samples) for one, samples in zip(taught, apart, strict=True)]


def taught_by(path: Path, how: How) -> Taught:
    """The samples of a session, or those that were exported from one.

    Raises what reading raises, and TrainingError where labels cannot be made from truth.
    """
    exported = samples_at(path)
    if exported is not None:
        if how.from_truth:
            raise TrainingError(
                f"{path} holds samples: truth belongs to sessions; leave --from-truth out"
            )
        return Taught(path, str(path), "", exported, {})
    with closing(Session.open(path)) as session:
        recording, run = session.recording, session.corrected_run
        if run is None or not len(run.parts.get("frame", ())):
            raise TrainingError(
                f"{path}: its tracks have no body parts; track it with three-part first"
            )
        if how.from_truth:
            labels, people = _true_labels(session, path, run.parts, how)
            samples = samples_of(labels, run.parts, recording.fps, recording.name, people)
            said: Mapping[PartKey, PartLabel] = {label.key: label for label in labels}
        else:
            samples = samples_from(
                session.labels, session.tracks, run, recording.fps, recording.name
            )
            said = session.labels.parts
        return Taught(path, recording.name, recording.footage, samples, said)


def footage_of(session: Session, how: How) -> Recording:
    """The recording of a session. Raises RecordingMissing, which names what `train` can be told."""
    try:
        return session.open_recording(allow_outside=how.allow_outside)
    except RecordingMissing as missing:
        way = "put it beside the session" if how.allow_outside else "allow it (--allow-outside)"
        named = str(missing).replace("name its place (--recording PATH)", way)
        raise RecordingMissing(f"{session.path}: {named}") from missing


def _true_labels(
    session: Session, path: Path, parts: Columns, how: How
) -> tuple[list[PartLabel], dict[int, int]]:
    """Labels of the run as it was made, by the truth beside its recording; who each track is."""
    with footage_of(session, how) as recording:
        truth = recording.folder / TRUE_PARTS
        if not truth.is_file():
            raise TrainingError(f"{path}: beside its recording is no {TRUE_PARTS}; label by hand")
        true, fps = read_true_parts(truth), recording.fps
        return labels_from_truth(true, parts, fps), people_followed(true, parts, fps)
