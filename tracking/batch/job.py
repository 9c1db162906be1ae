"""The work on one recording: track, keep, look through, score, export.

It writes to the attempt's workplace alone. What became of it is written last, and synced, so that
whatever happens to anybody afterwards, finished work is found and never done twice.
"""

from __future__ import annotations

import errno
import time
import traceback
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tracking.atomic_output import replace_with
from tracking.batch.order import content_digest, digest_of, files_in
from tracking.batch.outcome import Cause, Outcome, State, failure
from tracking.batch.protection import state_of, why_protected
from tracking.batch.recordings import Entry, boxes_of_entry, reason_of
from tracking.batch.results import counted, export_result, look_through, score_result, thumbnail_of
from tracking.batch.signature import signature_of
from tracking.batch.task import Finished, Task
from tracking.detections import with_relative_paths
from tracking.errors import (
    OutputError,
    SessionError,
    TrackwrightError,
    told_by_system,
)
from tracking.formats.schema_files import schema_of_project
from tracking.pipeline import track
from tracking.recording import OpenOptions, Recording, open_recording
from tracking.session import Session
from tracking.session.reference import refer_to
from tracking.settings import settings_values
from tracking.stamps import software
from tracking.trackers import TrackerSpec, best_tracker, detector_of, parse_settings, tracker_named
from tracking.trackers.step_watch import limited_steps
from tracking.tracks import Labels, Run
from tracking.translation import N_, Message, joined, msg

Tell = Callable[[str, int, int], None]
"""Told the stage, and the steps done of how many."""
_DISK = frozenset(
    {
        *(errno.EIO, errno.ENOSPC, errno.EDQUOT, errno.ESTALE, errno.ETIMEDOUT, errno.EMFILE),
        *(errno.ENFILE, errno.EAGAIN, errno.EBUSY, errno.EROFS, errno.ENOMEM, errno.EINTR),
        *(errno.ENODEV, errno.ENXIO, errno.EREMOTEIO if hasattr(errno, "EREMOTEIO") else errno.EIO),
    }
)
"""What disks say that may pass."""
READING, TRACKING, FINISHING, SAVING = (
    *(N_("reading"), N_("tracking"), N_("finishing"), N_("saving")),
)
LOOKING, SCORING, EXPORTING = N_("looking through"), N_("scoring"), N_("exporting")
"""What is told of the work on a recording."""
_OPENCV_MEMORY = -4
"""Its code of an error for want of memory."""


def do_task(task: Task, tell: Tell) -> Outcome:
    """Do all that a task asks for; what went wrong is in the outcome. It is on disk then."""
    began_s = time.monotonic()
    try:
        outcome = _Job(task, tell).work()
    except Exception as error:
        outcome = _failed(error)
    outcome = replace(outcome, seconds=time.monotonic() - began_s)
    try:
        task.workplace.folder.mkdir(exist_ok=True)
        finished = Finished(task.name, task.path, task.asked, outcome)
        replace_with(task.workplace.outcome, finished.as_bytes())
    except (OSError, OutputError, ValueError) as error:
        return _failed(error)
    return outcome


@dataclass(frozen=True, slots=True, eq=False)
class _Made:
    """A recording's session, where it is, and what is known of how it came about."""

    session: Path
    digest: str
    tracked: bool
    corrected: bool = False


class _Job:
    def __init__(self, task: Task, tell: Tell) -> None:
        self._task, self._tell = task, tell
        self._seen = state_of(task.session)
        """As the work begins: whoever changes the session later must not lose that."""

    def work(self) -> Outcome:
        """The outcome. Raises whatever goes wrong."""
        task = self._task
        order = task.order
        boxes = boxes_of_entry(Entry(task.name, task.path), order)
        self._tell(READING, 0, 0)
        options = OpenOptions(allow_outside=order.allow_outside)
        before = signature_of(task.path, boxes, (), task.out)
        with open_recording(task.path, options) as recording:
            files = _files_of(recording)
            outside = _outside(task.path, (*files, *recording.calibration_files))
            if before != signature_of(task.path, boxes, (), task.out):
                raise _changed(task.path)
            before = signature_of(task.path, boxes, outside, task.out)
            outcome = self._of(recording, files, boxes)
            if before != signature_of(task.path, boxes, outside, task.out):
                raise _changed(task.path)
            return replace(outcome, signature=before, outside=tuple(map(str, outside)))

    def _of(
        self, recording: Recording, files: tuple[Path, ...], boxes: tuple[Path, ...]
    ) -> Outcome:
        """The outcome of an opened recording."""
        fingerprint = _fingerprint(recording, files, boxes, self._task.asked)
        spec, settings = self._asked(recording, boxes)
        found = self._kept(fingerprint) or self._found(recording, spec, settings)
        if found is None and (why := self._protected()):
            return Outcome(State.SKIPPED, Cause.PROTECTED, why)
        made = found or self._tracked(recording, spec, settings)
        return self._outcome(recording, made, fingerprint)

    def _kept(self, fingerprint: str) -> _Made | None:
        """The session of the last time where it still is what it was made as; else None."""
        known, session = self._task.known, self._task.session
        if known is None or known.fingerprint != fingerprint or not known.session:
            return None
        if not session.is_file() or session.is_symlink():
            return None
        if (digest := content_digest([session])) == known.session:
            return _Made(session, digest, tracked=False, corrected=known.corrected)
        if _is_corrected(session):
            return _Made(session, digest, tracked=False, corrected=True)
        return None

    def _found(self, recording: Recording, spec: TrackerSpec, settings: Any) -> _Made | None:
        """A session that stands there and is what is asked for, where no ledger tells; else None.

        So a ledger that was lost costs no tracking.
        """
        known, place, order = self._task.known, self._task.session, self._task.order
        if known is not None and (known.session or known.state is not State.SKIPPED):
            return None
        if place.is_symlink() or not place.is_file():
            return None
        if order.detections or order.detections_right:
            return None
        reference = refer_to(recording, self._task.out)
        of = (reference.key, reference.manifest, reference.calibration)
        wanted = settings_values(with_relative_paths(recording, settings))
        asked = (spec.name, wanted, order.seed, software(), detector_of(spec.name, wanted))
        try:
            with closing(Session.look_into(place)) as session:
                run, there = session.corrected_run, session.recording
                if run is None or session.damage:
                    return None
                if (there.key, there.manifest, there.calibration) != of:
                    return None
                made = (run.tracker, dict(run.settings), run.seed, run.software, run.detector)
                if made != asked or run.frames != (0, recording.frame_count):
                    return None
                corrected = len(session.history) > 0
        except SessionError:
            return None
        return _Made(place, content_digest([place]), tracked=False, corrected=corrected)

    def _asked(self, recording: Recording, boxes: tuple[Path, ...]) -> tuple[TrackerSpec, Any]:
        """The tracker and its settings. Raises SettingsError."""
        order = self._task.order
        spec = tracker_named(order.tracker or best_tracker(recording))
        names = ("detections.file", "detections.file_right")
        patterns = (order.detections, order.detections_right)
        wanted = [name for name, pattern in zip(names, patterns, strict=True) if pattern]
        files = {name: str(path) for name, path in zip(wanted, boxes, strict=True)}
        return spec, parse_settings(spec, dict(order.settings) | files)

    def _protected(self) -> Message | None:
        """Why the session that is there must not be replaced; None: it may."""
        if self._task.order.force:
            return None
        return why_protected(self._task.session, own=self._task.known is not None)

    def _tracked(self, recording: Recording, spec: TrackerSpec, settings: Any) -> _Made:
        task = self._task
        asked = (recording, spec.name, settings, task.order.seed)
        with track(*asked, spool=task.out) as work, limited_steps(spec.name) as limited:
            start, stop = work.frames
            while (result := limited(lambda: next(work, None))) is not None:
                self._tell(TRACKING, result.frame + 1 - start, stop - start)
            self._tell(FINISHING, 0, 0)
            notes = (*recording.notes, *work.notes)
            run = replace(work.run(), notes=tuple(dict.fromkeys(notes)))
        self._tell(SAVING, 0, 0)
        place = task.workplace.session
        labels = Labels(schema=schema_of_project(recording.folder, place.parent).schema)
        Session.create(recording, [run], place, labels=labels).close()
        return _Made(place, content_digest([place]), tracked=True)

    def _outcome(self, recording: Recording, made: _Made, fingerprint: str) -> Outcome:
        """What is told of a session, with all that is made of it."""
        task, order, known = self._task, self._task.order, self._task.known
        same = known is not None and known.session == made.digest and not made.tracked
        task.workplace.folder.mkdir(exist_ok=True)
        with closing(Session.look_into(made.session)) as session:
            run = session.corrected_run
            outcome = Outcome(
                State.DONE,
                tracked=made.tracked,
                fingerprint=fingerprint,
                session=made.digest,
                session_state=() if made.tracked and order.force else self._seen,
                reference=session.recording.key,
                folder=str(recording.folder.resolve()),
                corrected=made.corrected,
                notes=run.notes if isinstance(run, Run) else (),
                tracker="" if run is None else run.tracker,
                frames=recording.frame_count,
                fps=recording.fps,
            )
            if same and known is not None:
                outcome = counted(outcome, known.people, known.review_rows)
            else:
                self._tell(LOOKING, 0, 0)
                outcome = look_through(outcome, session)
                replace_with(task.workplace.thumbnail, thumbnail_of(recording, session))
            self._tell(SCORING, 0, 0)
            outcome = score_result(outcome, task, recording, session, known if same else None)
            if order.exports:
                self._tell(EXPORTING, 0, 0)
            outcome = export_result(outcome, task, recording, session, known if same else None)
            return replace(outcome, notes=tuple(dict.fromkeys(outcome.notes)))


def _changed(path: Path) -> OSError:
    return OSError(errno.EBUSY, "the recording changed while it was read", str(path))


def _outside(path: Path, files: tuple[Path, ...]) -> tuple[Path, ...]:
    """Those of the files that are not in the recording's folder, also through ".." or a link."""
    folder = path.resolve()
    parents = {each.parent for each in files}
    inside = {parent: parent.resolve().is_relative_to(folder) for parent in parents}
    outside = (each for each in files if each != path and not inside[each.parent])
    return tuple(each.absolute() for each in outside)


def _is_corrected(place: Path) -> bool:
    try:
        with closing(Session.look_into(place)) as session:
            return len(session.history) > 0 and not session.damage
    except SessionError:
        return False


def _files_of(recording: Recording) -> tuple[Path, ...]:
    """The files that pictures come from."""
    files = [*recording.picture_files()]
    if recording.is_stereo:
        files += recording.picture_files(right=True)
    if recording.has_depth:
        files += list(files_in(recording.sources[-1]))
    return tuple(dict.fromkeys(files))


def _fingerprint(
    recording: Recording, files: tuple[Path, ...], boxes: tuple[Path, ...], asked: str
) -> str:
    sources = [[one.size_bytes, one.sha256] for one in recording.fingerprints()]
    pictures = content_digest(files)
    detections = [content_digest(files_in(each)) for each in boxes]
    texts = [recording.manifest_text, recording.calibration_text]
    return digest_of([sources, pictures, detections, texts, asked])


def _failed(error: Exception) -> Outcome:
    """What went wrong, and whether it may pass."""
    cause: BaseException | None = error
    while cause is not None:
        if isinstance(cause, MemoryError) or _is_opencv_memory(cause):
            return failure(Cause.LIMIT, msg("it needs more memory than it may have"))
        if isinstance(cause, OSError) and cause.errno in _DISK:
            return failure(Cause.DISK, _reason(error))
        cause = cause.__cause__ or cause.__context__
    if isinstance(error, OutputError):
        return failure(Cause.DISK, _reason(error))
    if isinstance(error, (TrackwrightError, OSError)):
        return failure(Cause.INPUT, _reason(error))
    trace = "".join(traceback.format_exception(error))
    last = traceback.extract_tb(error.__traceback__)[-1:]
    where = joined(", ", [f"{Path(frame.filename).name}:{frame.lineno}" for frame in last])
    why = msg(
        "this is a bug in trackwright: {kind}: {error} ({where}); please report it",
        kind=type(error).__name__,
        error=error,
        where=where,
    )
    return failure(Cause.BUG, why, trace=trace[-20_000:])


def _reason(error: Exception) -> Message:
    return told_by_system(error) or reason_of(error)


def _is_opencv_memory(error: BaseException) -> bool:
    return getattr(error, "code", None) == _OPENCV_MEMORY and type(error).__module__ == "cv2"
