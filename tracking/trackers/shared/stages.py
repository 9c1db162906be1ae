"""How long the stages of repeated work take, for whoever measures speed."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any, TypeVar

T = TypeVar("T")


class Stages:
    """A clock for each stage.

    Attributes:
        spent_s: seconds spent so far, by name.
    """

    def __init__(self, *names: str) -> None:
        """All stages that will be timed."""
        self.spent_s = dict.fromkeys(names, 0.0)

    def timed(self, name: str, work: Callable[..., T], *args: Any) -> T:
        """What the work gives; its time counts for the stage."""
        began = time.perf_counter()
        done = work(*args)
        self.spent_s[name] += time.perf_counter() - began
        return done
