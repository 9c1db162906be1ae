"""Results put where they belong, from the hidden places where workers made them.

Nothing is done twice and nothing half: what a worker finished stands in its workplace until the
ledger says so. Each step may be the last one before the power fails.
"""

from __future__ import annotations

import contextlib
import os
import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from tracking.atomic_output import check_target
from tracking.batch.order import content_digest
from tracking.batch.outcome import Cause, Outcome, State
from tracking.batch.protection import why_changed
from tracking.batch.signature import file_state
from tracking.batch.task import HIDDEN, Workplace
from tracking.errors import OutputError, TrackwrightError, told_by_system
from tracking.owned_files import sync_folder
from tracking.translation import message_of

REPORT, EXPORT = "report", "export"
"""Folders in the output folder."""
SCORE_PAGE = "report.html"
"""In the folder of a recording's report, as `scoring.report` calls it."""


def score_page(out: Path, name: str) -> Path:
    """Where the page on a recording's score stands in the output folder."""
    return out / REPORT / name / SCORE_PAGE


def publish(place: Workplace, name: str, outcome: Outcome) -> Outcome:
    """Put what an attempt made in its place; the outcome, failed where that is not possible.

    A session that somebody changed, or has open, since the attempt began is not replaced.

    What is there already, from a try before the power failed, stays. The names are synced by
    `sync_published`.
    """
    if not outcome.is_done:
        return outcome
    session = place.out / f"{name}.h5"
    try:
        if place.session.exists():
            if (why := why_changed(session, outcome.session_state)) is not None:
                return outcome.set_back(State.SKIPPED, Cause.PROTECTED, why)
            check_target(session)
            place.session.replace(session)
        _put_page(place, name)
        _put_exports(place)
        state = file_state(session)
        if state is None:
            raise OutputError("{path} has gone", path=session)
        return replace(outcome, session_state=state) if outcome.tracked else outcome
    except (OSError, OutputError) as error:
        why = told_by_system(error) or message_of(error)
        why = error.message if isinstance(error, TrackwrightError) else why
        if outcome.tracked and (place.session.exists() or not session.exists()):
            return outcome.set_back(State.FAILED, Cause.DISK, why)
        return outcome.failed(Cause.DISK, why)


def is_whole(place: Workplace, name: str, outcome: Outcome) -> bool:
    """Whether a finished attempt's session is there, in its workplace or in its place."""
    if not outcome.is_done:
        return True
    for file in (place.session, place.out / f"{name}.h5"):
        with contextlib.suppress(OSError):
            if file.is_file() and not file.is_symlink():
                return content_digest([file]) == outcome.session
    return False


def sync_published(out: Path) -> None:
    """Make the names of published results last. Raises OSError."""
    for folder in (out, out / REPORT):
        if folder.is_dir():
            sync_folder(folder)
    with contextlib.suppress(FileNotFoundError):
        for each in os.scandir(out / EXPORT):
            sync_folder(Path(each.path))


def workplaces(out: Path, prefix: str) -> Iterator[Workplace]:
    """The workplaces of attempts whose tokens begin so."""
    begins = f"{HIDDEN}{prefix}"
    names = {
        name.removeprefix(HIDDEN).removesuffix(".h5")
        for name in os.listdir(out)  # noqa: PTH208 - names alone
        if name.startswith(begins) and not name.endswith(".part")
    }
    yield from (Workplace(out, name) for name in sorted(names))


def clear(place: Workplace) -> None:
    """Remove whatever an attempt left in its workplace."""
    shutil.rmtree(place.folder, ignore_errors=True)
    from tracking.session.session_writer import companions  # takes long to import

    shutil.rmtree(companions(place.session), ignore_errors=True)
    for file in (place.session, place.folder):  # or a sign of life, which is a file
        with contextlib.suppress(OSError):
            file.unlink(missing_ok=True)


def clear_unfinished(place: Workplace) -> None:
    """The same of an attempt that ended somewhere within."""
    clear(place)
    clear_parts(place.out, place.token)


def clear_parts(out: Path, prefix: str) -> None:
    """Remove unfinished files that no workplace holds: of writing a session."""
    begins = (f".{HIDDEN}{prefix}", f"..{HIDDEN}{prefix}")
    for name in os.listdir(out):  # noqa: PTH208
        if name.startswith(begins):
            path = out / name
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path, ignore_errors=True)
            else:
                with contextlib.suppress(OSError):
                    path.unlink()


def _put_page(place: Workplace, name: str) -> None:
    if not place.page.is_dir():
        return
    target = place.out / REPORT / name
    target.parent.mkdir(exist_ok=True)
    if target.exists():
        shutil.rmtree(target)
    place.page.rename(target)


def _put_exports(place: Workplace) -> None:
    if not place.exports.is_dir():
        return
    for folder in place.exports.iterdir():
        target = place.out / EXPORT / folder.name
        target.mkdir(parents=True, exist_ok=True)
        for each in folder.iterdir():
            there = target / each.name
            if there.is_dir() and not there.is_symlink():
                shutil.rmtree(there)
            each.replace(there)
