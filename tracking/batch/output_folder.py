"""The output folder of a batch, in which one program works at a time; shards, and how they meet."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from tracking.batch.ledger import NAME, Ledger
from tracking.batch.report import read_reported, write_page
from tracking.errors import OutputError
from tracking.file_lock import SessionLock

LOCK = ".batch.lock"
"""In an output folder; held by the program that works there."""
_SHARDS = "shards"
_MERGE_S = 120.0
_WAIT_S = 0.25


@dataclass(frozen=True, slots=True)
class Shard:
    """A part of a batch that is worked on by itself.

    Attributes:
        number: from 1 on. count: how many parts there are.
    """

    number: int
    count: int

    @property
    def name(self) -> str:
        """Of its ledger."""
        return f"{self.number}-of-{self.count}"


def ledger_path(out: Path, shard: Shard | None = None) -> Path:
    """Where the ledger of a batch, or of a shard of it, stands."""
    return out / NAME if shard is None else out / _SHARDS / f"{shard.name}.sqlite"


@contextlib.contextmanager
def batch_folder(out: Path, shard: Shard | None = None) -> Iterator[Ledger]:
    """The ledger of an output folder, which this program alone works in while the block runs.

    What shards found out is in it, once no shard works any more.
    Raises OutputError where another program works there, or the folder cannot be used.
    """
    folder = out if shard is None else out / _SHARDS
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(
            "cannot make folder {folder}: {reason}; choose another",
            folder=folder,
            reason=error.strerror,
        ) from error
    lock = _locked(out / LOCK if shard is None else folder / f".{shard.name}.lock", out)
    try:
        others = [out / LOCK] if shard is not None else sorted((out / _SHARDS).glob(".*.lock"))
        for other in others:
            if SessionLock(other).is_held:
                raise _busy(out, SessionLock(other))
        with Ledger(ledger_path(out, shard)) as ledger:
            if shard is None:
                _take_over_shards(ledger, out)
            yield ledger
    finally:
        lock.release()


def merge_shard(ledger: Ledger, out: Path) -> Path:
    """Put what a shard found out into the ledger of the whole, and write the report on that.

    Other shards may be at work: no one waits for the page, which may take long, to put its own
    in. Gives the page's path. Raises OutputError.
    """
    with _merging(out), Ledger(ledger_path(out)) as whole:
        whole.take_over(ledger)
        whole.commit()
    return _write_report(out)


def _write_report(out: Path) -> Path:
    """Write the page on the ledger of the whole as it is now; of several writers, one by one.

    So the last one has seen what all put in. Who waited too long writes all the same: the page
    is always a whole one, and the last command of a batch, without a shard, writes it again.
    """
    lock = SessionLock(out / _SHARDS / ".page")
    held = _acquire(lock)
    try:
        with _merging(out), Ledger(ledger_path(out)) as whole:
            reported = read_reported(whole)
        return write_page(reported, out)
    finally:
        if held:
            lock.release()


@contextlib.contextmanager
def _merging(out: Path) -> Iterator[None]:
    """Alone with the ledger of the whole. Raises OutputError where others stay too long."""
    lock = SessionLock(out / _SHARDS / ".merge")
    if not _acquire(lock):
        raise _busy(out, lock)
    try:
        yield
    finally:
        lock.release()


def _acquire(lock: SessionLock) -> bool:
    """Wait for a lock; whether it was given in time."""
    until_s = time.monotonic() + _MERGE_S
    while not lock.acquire():
        if time.monotonic() > until_s:
            return False
        time.sleep(_WAIT_S)
    return True


def _take_over_shards(ledger: Ledger, out: Path) -> None:
    for path in sorted((out / _SHARDS).glob("*.sqlite")):
        with Ledger(path) as other:
            ledger.take_over(other)
    ledger.commit()


def _locked(path: Path, out: Path) -> SessionLock:
    lock = SessionLock(path)
    try:
        if lock.acquire():
            return lock
    except OSError as error:
        raise OutputError(
            "cannot work in {out}: {reason}; choose another folder",
            out=out,
            reason=error.strerror or str(error),
        ) from error
    raise _busy(out, lock)


def _busy(out: Path, lock: SessionLock) -> OutputError:
    return OutputError(
        "another batch works in {out} ({holder}); wait for it, or choose another folder",
        out=out,
        holder=lock.holder(),
    )
