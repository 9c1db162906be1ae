"""The one place where an error becomes a line on stderr and an exit status."""

from __future__ import annotations

import os
import sys
import traceback
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import platformdirs

from app.cli.output import say
from app.core.interrupts import INTERRUPTED, STOPPED
from tracking.errors import OutputError, SettingsError, TrackwrightError, told_by_system
from tracking.translation import Message, joined, message_of, msg, tr


class EndedEarlyError(Exception):
    """Long work that could not go on, for a reason of its own that is its cause.

    Attributes:
        kept: what of it was kept, and where; "": nothing.
    """

    def __init__(self, what: str, kept: Message | None = None, /, **values: object) -> None:
        """What ended, and when, as a template: it begins the line that is told."""
        super().__init__(msg(what, **values))
        self.kept = kept or Message()


DONE, FAILED, MISUSED = 0, 1, 2
_LOG_BYTES = 1 << 20


def run_reporting_errors(work: Callable[[], object], *, debug: bool) -> int:
    """Do the work; the exit status, with at most one line on stderr unless `debug`."""
    try:
        try:
            work()
        finally:
            _flush()
    except SystemExit as stop:
        if stop.code == INTERRUPTED:  # what Typer makes of Ctrl+C
            return _line(STOPPED, INTERRUPTED)
        return stop.code if isinstance(stop.code, int) else DONE if stop.code is None else FAILED
    except KeyboardInterrupt:
        return _line(STOPPED, INTERRUPTED)
    except BrokenPipeError:
        _drop_stdout()  # whoever read our output has gone; say no more
        return FAILED
    except Exception as error:
        _shown(debug)
        # What was typed is no name, setting or value there is; all else is the input's fault.
        return _line(_reason(error), MISUSED if isinstance(error, SettingsError) else FAILED)
    return DONE


def _flush() -> None:
    """Have all output written. Raises OutputError where the system refuses."""
    try:
        sys.stdout.flush()
    except OutputError:
        _drop_stdout()
        raise


def _drop_stdout() -> None:
    """Have Python say nothing either when it closes stdout."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _reason(error: BaseException) -> Message:
    """What went wrong and what to do about it; the traceback of a bug is kept."""
    if isinstance(error, EndedEarlyError):
        cause = error.__cause__
        why = joined(": ", (error, _reason(cause))) if cause else message_of(error)
        return joined("; ", (why, error.kept)) if error.kept else why
    if isinstance(error, TrackwrightError):
        return error.message
    if isinstance(error, MemoryError):
        return msg("not enough memory; try a shorter range of frames")
    if said := told_by_system(error):
        return said
    return msg(
        "this is a bug in trackwright: {kind}: {error}; please report it with {place}",
        kind=type(error).__name__,
        error=error,
        place=_logged(error),
    )


def _line(message: str, status: int) -> int:
    say(f"trackwright: {' '.join(tr(message).split())}")
    return status


def _shown(debug: bool) -> None:
    if debug:
        traceback.print_exc()


def _logged(error: BaseException) -> Message:
    """Keep the traceback of a bug; says where, or how to see it."""
    log = Path(platformdirs.user_log_dir("trackwright", appauthor=False)) / "errors.log"
    try:
        log.parent.mkdir(parents=True, exist_ok=True)
        mode = "a" if log.exists() and log.stat().st_size < _LOG_BYTES else "w"
        with log.open(mode, encoding="utf-8") as stream:
            trace = "".join(traceback.format_exception(error))
            stream.write(f"{datetime.now(UTC).isoformat()}\n{trace}\n")
    except OSError:
        return msg("what --debug prints")
    return msg("{log}", log=log)
