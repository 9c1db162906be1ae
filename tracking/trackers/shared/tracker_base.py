"""What every tracker holds besides its people: settings, the time of the last frame, ids given."""

from __future__ import annotations

from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from tracking.translation import Message

SettingsT = TypeVar("SettingsT")


class FrameClock:
    """The time from each frame to the next one."""

    def __init__(self) -> None:
        """Before the first frame."""
        self._last_s: float | None = None

    def elapsed_s(self, time_s: float) -> float:
        """Seconds since the frame before; 0 in the first.

        No time has passed where a frame bears the time of one before it, or an earlier one.
        """
        before = time_s if self._last_s is None else self._last_s
        self._last_s = max(time_s, before)
        return max(time_s - before, 0.0)

    def set(self, time_s: float) -> None:
        """The last frame was at this time."""
        self._last_s = time_s


class TrackIds:
    """The ids of new tracks, one after the other, without gaps.

    Attributes:
        last: the last id given; 0: none.
    """

    def __init__(self, last: int = 0) -> None:
        self.last = last

    def take(self, count: int) -> NDArray[np.int32]:
        """(count,) the next ids."""
        ids = np.arange(self.last + 1, self.last + 1 + count, dtype=np.int32)
        self.last += count
        return ids


class TrackerBase(Generic[SettingsT]):
    """Settings, clock and ids of a tracker; trackers add people and the step."""

    def __init__(self, settings: SettingsT) -> None:
        """Before the first frame."""
        self._settings = settings
        self._clock = FrameClock()
        self._ids = TrackIds()

    @property
    def settings(self) -> SettingsT:
        """The settings in force."""
        return self._settings

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes for the user, a line each."""
        return ()
