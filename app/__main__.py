"""Where the program starts: `trackwright` and `python -m app`."""

from __future__ import annotations

import signal
import sys
from collections.abc import Sequence

from app.cli.commands import program
from app.cli.failure import MISUSED, told

NOT_BUILT = ("count", "import", "batch")
"""Commands that are announced; typing one is answered with a line of its own."""


def main() -> None:
    """Run what was typed and exit."""
    # A polite request to end leaves no more behind than Ctrl+C does.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    sys.exit(run(sys.argv[1:]))


def run(arguments: Sequence[str]) -> int:
    """Run a command; the exit status: 0 done, 1 failed, 2 wrongly asked for."""
    debug = "--debug" in arguments
    words = [word for word in arguments if word != "--debug"]
    if words and words[0] in NOT_BUILT:
        print(f"trackwright: {words[0]} is not built yet", file=sys.stderr)
        return MISUSED
    return told(lambda: program(words, prog_name="trackwright"), debug=debug)


if __name__ == "__main__":
    main()
