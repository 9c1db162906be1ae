"""`open`: the window."""

from __future__ import annotations

from pathlib import Path

from app.cli.display import has_display
from app.cli.recordings import Bare, options_of
from tracking.errors import OutputError


def run_open(path: Path | None, bare: Bare) -> None:
    """Show the window until it is closed.

    Raises:
        OutputError: there is no display.
    """
    options = options_of(bare)
    if not has_display():
        raise OutputError("no display to open a window on; use info, track or demo --no-gui")
    from app.views.application import run

    raise SystemExit(run(path or bare.left, options))
