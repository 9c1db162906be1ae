"""How long work says how far it is."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[int, int], None]
"""Called with the steps done and the steps there are; raises where the user has cancelled."""


_STEPS = 1000


def stage_of(progress: Progress, begin: float, end: float) -> Progress:
    """The progress of a stage of some work, which lasts from one share of the whole to another."""

    def tell(done: int, total: int) -> None:
        progress(round(_STEPS * (begin + (end - begin) * done / max(total, 1))), _STEPS)

    return tell


def no_progress(_done: int, _total: int) -> None:
    """For work nobody watches."""
