"""A save on its way, so that writing can run beside the window."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from tracking.session.image import Snapshot, Stamps, write_image
from tracking.session.session_writer import MAX_BACKUPS, replace_verified
from tracking.session.store import Store
from tracking.stamps import make_id, now, software


@dataclass(frozen=True, slots=True)
class PendingSave:
    """A save on its way. `write` may run on any thread, the rest is the session's.

    Attributes:
        snapshot, path: what to write and where to.
        content: the session's count of changes that the snapshot holds.
        store: the right to write there.
        most: how many backups are kept.
        written: done when the new file is in its place; holds the error where that failed.
    """

    snapshot: Snapshot
    path: Path
    content: int
    store: Store
    most: int = MAX_BACKUPS
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


def next_stamps(stamps: Stamps, own: Stamps, store: Store | None) -> Stamps:
    """Of the next save of what bears `stamps`, under the session's own name.

    Args:
        own: of the session as it was saved last.
        store: whose journal the save takes in; None: it goes elsewhere.
    """
    journal = store.journal if store is not None else None
    origin = journal.origin if journal is not None else None
    return replace(
        stamps,
        session=own.session,
        save=make_id(),
        previous_save=origin[1] if origin else own.save if store is not None else "",
        included=journal.last if journal is not None else 0,
        modified=now(),
        software=software(),
    )
