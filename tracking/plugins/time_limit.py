"""A limit of time for code of a plug-in."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TypeVar

from tracking.errors import PluginError, TrackwrightError
from tracking.plugins.blame import accused, blaming, failed
from tracking.plugins.offers import Offer

T = TypeVar("T")


def in_time(work: Callable[[], T], offer: Offer, seconds: float) -> T:
    """What the work gives.

    It runs in a thread: the one that asks, often the window's, is never held up for good. A thread
    that hangs is left to itself, and does not hold up the end of the program.

    Raises PluginError where it takes longer, or raises anything but errors of our own.
    """
    found: list[T] = []
    wrong: list[BaseException] = []

    def do() -> None:
        try:
            with blaming(offer):
                found.append(work())
        except BaseException as error:  # of a foreign package: SystemExit, too
            wrong.append(error)

    thread = threading.Thread(target=do, daemon=True, name=f"plug-in {offer.name}")
    thread.start()
    thread.join(seconds)
    if wrong:
        raise wrong[0] if isinstance(wrong[0], TrackwrightError) else failed(offer, wrong[0])
    if not found:
        raise overdue(offer, seconds)
    return found[0]


def overdue(offer: Offer, seconds: float) -> PluginError:
    """The error for a plug-in that took longer than it may."""
    return accused(offer, "it did not answer within {seconds:g} s", seconds=seconds)
