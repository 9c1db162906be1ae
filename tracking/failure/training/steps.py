"""Steps of long work: told as they are taken, and the place where it can be stopped."""

from __future__ import annotations

from tracking.progress import Progress


class Steps:
    """Counts steps of work of known length."""

    def __init__(self, total: int, progress: Progress | None = None) -> None:
        self._done, self._total, self._progress = 0, total, progress

    def take(self) -> None:
        """One step is done. Raises CancelledError where that is what `progress` does."""
        self._done += 1
        if self._progress is not None:
            self._progress(self._done, self._total)
