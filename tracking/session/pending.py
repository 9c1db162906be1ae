"""A save on its way, so that writing can run beside the window."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from tracking.session.image import Snapshot, write_image
from tracking.session.saving import GENERATIONS, replace_verified
from tracking.session.store import Store


@dataclass(frozen=True, slots=True)
class PendingSave:
    """A save on its way. `write` may run on any thread, the rest is the session's.

    Attributes:
        snapshot, path: what to write and where to.
        content: the session's count of changes that the snapshot holds.
        store: the right to write there.
        most: how many older generations are kept.
        written: done when the new file is in its place; holds the error where that failed.
    """

    snapshot: Snapshot
    path: Path
    content: int
    store: Store
    most: int = GENERATIONS
    written: Future[None] = field(default_factory=Future)

    def write(self) -> None:
        """Build, write and verify the file, and put it in its place.

        Raises OutputError, with the old file whole, where that fails.
        """
        try:
            replace_verified(self.path, partial(write_image, self.snapshot), self.most)
        except BaseException as why:
            self.written.set_exception(why)
            raise
        self.written.set_result(None)
