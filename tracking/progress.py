"""How long work says how far it is."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[int, int], None]
"""Called with the steps done and the steps there are; raises where the user has cancelled."""


def no_progress(_done: int, _total: int) -> None:
    """For work nobody watches."""
