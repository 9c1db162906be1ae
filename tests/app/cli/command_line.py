"""What the tests of the command line call a command."""

from __future__ import annotations

from collections.abc import Callable

Trackwright = Callable[..., tuple[int, str, str]]
"""Takes words and paths; gives exit status, stdout and stderr."""
