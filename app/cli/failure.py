"""The one place where an error becomes a line on stderr and an exit status."""

from __future__ import annotations

import os
import sys
import traceback
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

import platformdirs

from tracking.errors import TrackwrightError

DONE, FAILED, MISUSED, INTERRUPTED = 0, 1, 2, 130
_LOG_BYTES = 1 << 20
_STOPPED = "interrupted; nothing half-done was kept"


def told(work: Callable[[], object], *, debug: bool) -> int:
    """Do the work; the exit status, with at most one line on stderr unless `debug`."""
    try:
        try:
            work()
        finally:
            sys.stdout.flush()
    except SystemExit as stop:
        if stop.code == INTERRUPTED:  # what Typer makes of Ctrl+C
            return _line(_STOPPED, INTERRUPTED)
        return stop.code if isinstance(stop.code, int) else DONE if stop.code is None else FAILED
    except KeyboardInterrupt:
        return _line(_STOPPED, INTERRUPTED)
    except BrokenPipeError:
        # Whoever read our output has gone; say no more, also not when Python closes stdout.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILED
    except TrackwrightError as error:
        _shown(debug)
        return _line(str(error), FAILED)
    except MemoryError:
        _shown(debug)
        return _line("not enough memory; try a shorter range of frames", FAILED)
    except Exception as error:
        _shown(debug)
        place = _logged()
        return _line(
            f"this is a bug in trackwright: {type(error).__name__}: {error}; "
            f"please report it with {place}",
            FAILED,
        )
    return DONE


def _line(message: str, status: int) -> int:
    print(f"trackwright: {' '.join(message.split())}", file=sys.stderr)
    return status


def _shown(debug: bool) -> None:
    if debug:
        traceback.print_exc()


def _logged() -> str:
    """Keep the traceback of a bug; says where, or how to see it."""
    log = Path(platformdirs.user_log_dir("trackwright", appauthor=False)) / "errors.log"
    try:
        log.parent.mkdir(parents=True, exist_ok=True)
        mode = "a" if log.exists() and log.stat().st_size < _LOG_BYTES else "w"
        with log.open(mode, encoding="utf-8") as stream:
            stream.write(f"{datetime.now(UTC).isoformat()}\n{traceback.format_exc()}\n")
    except OSError:
        return "what --debug prints"
    return str(log)
