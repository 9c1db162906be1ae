"""Steps of long work: told as they are taken, and the place where it can be stopped."""

from __future__ import annotations

from collections.abc import Callable

from tracking.errors import CancelledError
from tracking.progress import Progress


class Steps:
    """Counts steps of work of known length."""

    def __init__(
        self,
        total: int,
        progress: Progress | None = None,
        cancelled: Callable[[], bool] | None = None,
    ) -> None:
        self._done, self._total = 0, total
        self._progress, self._cancelled = progress, cancelled

    def take(self) -> None:
        """One step is done. Raises CancelledError where somebody asked to stop."""
        self._done += 1
        if self._progress is not None:
            self._progress(self._done, self._total)
        if self._cancelled is not None and self._cancelled():
            raise CancelledError("training was stopped; the detector is as it was before")
