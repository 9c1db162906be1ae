"""A virtual screen for as long as it is needed."""

from __future__ import annotations

import os
import select
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager

from app.cli.display import why_no_window

_SCREEN = "1920x1200x24"
_PATIENCE_S = 30


@contextmanager
def virtual_screen() -> Iterator[None]:
    """Start Xvfb on a free display and let Qt draw there; it is stopped at the end."""
    read, write = os.pipe()
    server = subprocess.Popen(
        [
            *("Xvfb", "-displayfd", str(write), "-screen", "0", _SCREEN),
            *("-nolisten", "tcp", "-terminate"),  # it also ends where this program was killed
        ],
        pass_fds=[write],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    ready, _, _ = select.select([read], [], [], _PATIENCE_S)
    with os.fdopen(read) as told:
        number = told.readline().strip() if ready else ""
    if not number:
        server.terminate()
        raise SystemExit("Xvfb did not start: apt-get install xvfb")
    before = {name: os.environ.get(name) for name in ("DISPLAY", "QT_QPA_PLATFORM")}
    os.environ |= {"DISPLAY": f":{number}", "QT_QPA_PLATFORM": "xcb"}
    try:
        if missing := why_no_window():
            raise SystemExit(missing)
        yield
    finally:
        server.terminate()
        server.wait()
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value
