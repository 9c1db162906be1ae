"""Work that was never saved: found again with its recording, and named where the window ends."""

from __future__ import annotations

import logging
from dataclasses import replace
from pathlib import Path

from app.core.document.document_loader import (
    OpenedDocument,
    is_unsaved_place,
    open_path,
    unsaved_folder,
)
from app.core.i18n import tr
from tracking.errors import TrackwrightError
from tracking.progress import Progress
from tracking.recording import OpenOptions, Recording
from tracking.session import Session, is_open, last_worked_on_s, recording_of

_log = logging.getLogger(__name__)
_MOST = 20
"""So many files of a recording's name are looked into, those worked on last first."""


def open_with_unsaved(
    path: Path, recording: Path | None, options: OpenOptions | None, report: Progress
) -> OpenedDocument:
    """The same as `open_path`, with what was never saved of a recording.

    Raises:
        CancelledError: by `report`; nothing stays open then.
    """
    opened = open_path(path, recording, options)
    try:
        if opened.document.session is None:
            opened = replace(opened, unsaved=find_left_behind(opened.document.recording, report))
        report(1, 1)
    except BaseException:
        opened.close()
        raise
    return opened


def find_left_behind(recording: Recording, report: Progress) -> Path | None:
    """The session of the recording worked on last, of those never saved that no window has open.

    Raises:
        CancelledError: by `report`.
    """
    try:
        found = _named_like(recording)
        footage = " ".join(part.sha256 for part in recording.fingerprints()) if found else ""
    except (TrackwrightError, OSError) as why:
        _log.info("what was never saved of %s is not looked for: %s", recording.path, why)
        return None
    for done, path in enumerate(found[:_MOST]):
        report(done, len(found[:_MOST]))
        if _is_of(path, footage):
            return path
    return None


def _named_like(recording: Recording) -> list[Path]:
    """The files that may be of the recording, the one worked on last first."""
    named = f"{recording.path.stem or 'session'}-"
    found = [one for one in unsaved_folder().glob("*.h5") if one.name.startswith(named)]
    return sorted(found, key=last_worked_on_s, reverse=True)


def _is_of(path: Path, footage: str) -> bool:
    try:
        return not is_open(path) and recording_of(path).footage == footage
    except (TrackwrightError, OSError) as why:
        _log.info("%s is not offered: %s", path, why)
        return False


def describe_unsaved(session: Session | None, *, held: bool, tracking: bool) -> list[str]:
    """What somebody should know who ends the program at the terminal, a line each.

    held: a result is in memory alone, and not on its way to the disk.
    tracking: a tracker is at work.
    """
    lines = []
    path = session.path if session is not None else None
    if path is not None and is_unsaved_place(path):
        kept = tr("Never saved, but kept: {path}. Open it, or its recording, to go on.", path=path)
        lines.append(kept)
    elif path is not None and session is not None and session.dirty:
        lines.append(tr("Unsaved edits are kept beside {path}. Open it to go on.", path=path))
    if held:
        lines.append(tr("A result that could not be kept on disk is lost."))
    if tracking:
        lines.append(tr("The running tracker was stopped; its result is not kept."))
    return lines


Question = tuple[str, str]
"""What is asked before something is left, and what is lost by it."""


def tracker_at_work(recording: str, tracker: str, status: str) -> Question:
    """A tracker has found something that is kept nowhere yet."""
    asked = tr(
        'The tracker {tracker} is still tracking "{recording}" ({status}).',
        tracker=tracker,
        recording=recording,
        status=status,
    )
    return asked, tr("What it found so far is lost. To keep it, cancel here and stop the tracker.")


def tracker_stopping(recording: str, tracker: str) -> Question:
    """A tracker was stopped, and its result is on its way to the disk."""
    asked = tr(
        'The tracker {tracker} is stopping; its tracks of "{recording}" are about to be kept.',
        tracker=tracker,
        recording=recording,
    )
    return asked, tr("Discard loses them. To keep them, cancel here.")


def result_in_memory(recording: str) -> Question:
    """What a tracker found could not be put on disk."""
    asked = tr('Save the tracks of "{recording}"?', recording=recording)
    return asked, tr("They are in memory only, and lost if they are discarded.")


def never_saved(recording: str) -> Question:
    """A session has no place of its own yet."""
    asked = tr('Save the tracks of "{recording}"?', recording=recording)
    return asked, tr("They were never saved. Discard deletes them, with all edits.")


def changes_unsaved(file: str, recording: str) -> Question:
    """A session was changed since it was saved."""
    asked = tr(
        'Save the changes to the session {file} of "{recording}"?', file=file, recording=recording
    )
    return asked, tr("Discard loses all changes since the last save.")
