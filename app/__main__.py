"""Where the program starts: `trackwright` and `python -m app`."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Sequence

import typer

from app.cli.commands.program import program
from app.cli.failure import MISUSED, run_reporting_errors
from app.cli.language import obeyed_language
from app.cli.output import escape_what_stdout_lacks, name_stdout_in_errors, say
from app.cli.sessions import print_notes
from app.cli.typer_texts import told_of
from app.core.interrupts import end_at_once
from tracking.translation import msg, use_language

_MISUSE: type[Exception] = next(
    kind for kind in typer.BadParameter.__mro__ if kind.__name__ == "UsageError"
)
"""What all wrong arguments raise; typer has no name for it that all its versions share."""
_THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")
"""What NumPy's matrix products read, when NumPy is imported, and the processes begun from here."""
_OPENCV_LOG = "OPENCV_LOG_LEVEL"
"""What OpenCV reads when it is imported, here and in the processes begun from here."""


def main() -> None:
    """Run what was typed and exit."""
    # The matrices here are small: shared out among threads, their products cost many times more.
    for variable in _THREADS:
        os.environ.setdefault(variable, "1")
    # Our own notes tell of broken pictures; OpenCV's warnings would stand amid them.
    os.environ.setdefault(_OPENCV_LOG, "SILENT")
    escape_what_stdout_lacks()
    name_stdout_in_errors()
    use_language()
    # A polite request to end leaves no more behind than Ctrl+C does.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    status = run(sys.argv[1:])
    end_at_once()  # what is to be kept is on disk
    sys.exit(status)


def run(arguments: Sequence[str]) -> int:
    """Run a command; the exit status: 0 done, 1 failed, 2 wrongly asked for."""
    debug = "--debug" in arguments
    words = [word for word in arguments if word != "--debug"]
    with print_notes():
        return run_reporting_errors(lambda: _obey(words), debug=debug)


def _obey(words: list[str]) -> None:
    """Run the command; what is wrongly asked for is told in a line like any other error."""
    words = obeyed_language(words)
    try:
        status = program(words or ["--help"], prog_name="trackwright", standalone_mode=False)
    except typer.Abort as stop:
        raise KeyboardInterrupt from stop
    except _MISUSE as misuse:
        say(msg("trackwright: {what}", what=told_of(misuse, words)))
        raise SystemExit(MISUSED) from misuse
    raise SystemExit((status or 0) if words else MISUSED)


if __name__ == "__main__":
    main()
