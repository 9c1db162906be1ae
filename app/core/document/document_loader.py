"""Opening, keeping and measuring documents: the long steps that run in the background."""

from __future__ import annotations

import os
import shutil
from dataclasses import dataclass
from pathlib import Path

from platformdirs import user_data_path

from app.core.colours.track_colours import TrackColours
from app.core.document.document import Document
from tracking.errors import OutputError
from tracking.formats.schema_files import schema_of_project
from tracking.owned_files import real_path
from tracking.recording import OpenOptions, Recording, open_recording
from tracking.session import (
    Importable,
    ImportOrigin,
    KnownRecordings,
    PendingSave,
    Session,
    find_backups,
    session_of_import,
)
from tracking.session.session_writer import (
    check_backup_file,
    companions,
    copy_file,
    free_name,
)
from tracking.tracks import Labels, Run


@dataclass(frozen=True, slots=True)
class OpenedDocument:
    """What was opened.

    Attributes:
        unsaved: of a recording the latest session that was never saved; None: there is none.
    """

    path: Path
    document: Document
    unsaved: Path | None = None

    def close(self) -> None:
        """Let its files go."""
        if self.document.session is not None:
            self.document.session.close()
        self.document.recording.close()


def unsaved_folder() -> Path:
    """Where sessions stand that were never given a place by the user."""
    return own_folder() / "unsaved"


def window_lock() -> Path:
    """A file that is locked while a window of this user is open."""
    own_folder().mkdir(parents=True, exist_ok=True)
    return own_folder() / "window.lock"


def open_path(
    path: Path, recording: Path | None = None, options: OpenOptions | None = None
) -> OpenedDocument:
    """Open a recording or a session (`*.h5`) with its recording.

    Args:
        path: what to open.
        recording: where the recording of a session is by now, if it is known to have moved.
        options: what a bare recording does not say of itself; of a session's recording only
            `allow_outside` counts, the rest is in the session.

    Raises:
        TrackwrightError: it cannot be opened; `RecordingMissing` where only the recording is gone.
    """
    if path.suffix.lower() != ".h5":
        return OpenedDocument(path, Document(open_recording(path, options)))
    session = Session.open(path)
    try:
        search = [recording] if recording is not None else []
        allowed = options is not None and options.allow_outside
        found = session.open_recording(search, known_recordings(), allow_outside=allowed)
        return OpenedDocument(path, Document(found, session))
    except BaseException:
        session.close()
        raise


def keep_run(
    recording: Recording, run: Run, path: Path | None = None, seen: TrackColours | None = None
) -> Session:
    """A session of a run that was just made, kept on disk from its first moment.

    Without a path it stands among the program's own files until the user gives it a place.
    Its people have their colours from now on: those `seen` while the tracker worked, where these
    tell them apart.

    Raises:
        OutputError, OSError: it cannot be written; nothing is left of it then.
    """
    colours = TrackColours.of_run(run, seen).places
    place = path or _unsaved_path(recording)
    labels = labels_at_first(recording)
    session = Session.create(recording, [run], place, colours=colours, labels=labels)
    remember_place(session, recording)
    return session


def keep_import(recording: Recording, found: Importable, origin: ImportOrigin) -> Session:
    """A session of tracks made elsewhere, kept like that of a run.

    Raises:
        OutputError, OSError: it cannot be written.
    """
    session = session_of_import(recording, found, origin)
    session.save(_unsaved_path(recording))
    remember_place(session, recording)
    return session


def session_by_hand(recording: Recording, labels: Labels | None = None) -> Session:
    """A session nothing was tracked for, to be labelled by hand, on disk from its first moment.

    It stands among the program's own files until the user gives it a place; labels: what was
    drawn before.

    Raises:
        OutputError, OSError: it cannot be written.
    """
    labels = labels or labels_at_first(recording)
    session = Session.create(recording, [], _unsaved_path(recording), labels=labels)
    remember_place(session, recording)
    return session


def labels_at_first(recording: Recording) -> Labels:
    """What a new session begins with: the attributes of people that its project says."""
    return Labels(schema=schema_of_project(recording.folder).schema)


def _unsaved_path(recording: Recording) -> Path:
    folder = unsaved_folder()
    folder.mkdir(parents=True, exist_ok=True)
    return _free_name(folder, recording.path.stem or "session")


def remember_place(session: Session, recording: Recording) -> None:
    """Note where the recording stands, so that the session finds it again unasked."""
    known_recordings().remember(session.recording, recording.folder)


def finish_save(session: Session, pending: PendingSave) -> None:
    """End a save; the file of a session that had no place of its own goes once it has one."""
    before, path = session.path, pending.path
    session.finish_save(pending)
    if before is not None and is_unsaved_place(before) and before != path:
        remove_session(before)


def discard(session: Session) -> None:
    """Forget what was done since the last save, and all of a session that was never saved."""
    session.close(discard=True)
    if session.path is not None and is_unsaved_place(session.path):
        remove_session(session.path)


def remove_session(path: Path) -> None:
    """Remove a session's file and what the program keeps beside it."""
    path.unlink(missing_ok=True)
    shutil.rmtree(companions(path), ignore_errors=True)


def copy_newest_backup(path: Path) -> Path | None:
    """The session as it was saved before, put beside it under a name of its own; None: none.

    Raises:
        OutputError: the copy cannot be written. UnsafeFileError: what is kept there is a link or
            another user's.
    """
    path = real_path(path)
    older = find_backups(path)
    if not older:
        return None
    check_backup_file(path, older[0])
    copy = path.with_name(f"{path.stem}-as-saved-before{path.suffix}")
    if os.path.lexists(copy):
        copy = free_name(path.with_name(f"{path.stem}-as-saved-before-{path.suffix}"))
    try:
        copy_file(older[0], copy)
    except OSError as error:
        raise OutputError(
            "{copy} cannot be written: {reason}", copy=copy, reason=error.strerror
        ) from error
    return copy


def is_unsaved_place(path: Path | None) -> bool:
    """Whether a session stands where the user never put it."""
    return path is None or path.parent == unsaved_folder()


def known_recordings() -> KnownRecordings:
    """Where this user's recordings stood when they were opened last."""
    return KnownRecordings(own_folder())


def own_folder() -> Path:
    """The program's folder among the user's data."""
    return user_data_path("trackwright", appauthor=False)


def _free_name(folder: Path, stem: str) -> Path:
    for number in range(1, 10_000):
        path = folder / f"{stem}-{number}.h5"
        if not path.exists():
            return path
    return folder / f"{stem}.h5"
