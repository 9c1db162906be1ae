"""Where the program starts in a folder that holds its own Python (`python -m tests.bundle`).

Other programs of ours are begun with `sys.executable`, which is this program itself there: it then
does what Python would do with these options.
"""

from __future__ import annotations

import runpy
import sys


def main() -> None:
    """Run what was typed, or, asked as a Python is asked, a module, a file or a text."""
    words = sys.argv[1:]
    if words[:1] == ["-P"]:  # nothing is found beside the file in any case
        words = words[1:]
    if words[:1] == ["-m"] and len(words) > 1:
        sys.argv = words[1:]
        runpy.run_module(words[1], run_name="__main__", alter_sys=True)
    elif words[:1] == ["-c"] and len(words) > 1:
        sys.argv = ["-c", *words[2:]]
        exec(compile(words[1], "<string>", "exec"), {"__name__": "__main__"})
    elif len(words) < len(sys.argv) - 1:
        sys.argv = words
        runpy.run_path(words[0], run_name="__main__")
    else:
        from app.core.interrupts import ending_at_once

        with ending_at_once():
            from app.__main__ import main as run_and_exit

        run_and_exit()


if __name__ == "__main__":
    main()
