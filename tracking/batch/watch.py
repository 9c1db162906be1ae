"""How far a batch is, in a file of its output folder: whoever looks there can watch and stop it."""

from __future__ import annotations

import contextlib
import json
import os
import time
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any, Final

from tracking.batch.outcome import Outcome
from tracking.batch.output_folder import LOCK
from tracking.batch.progress import BatchState, Listener
from tracking.errors import SessionError
from tracking.file_lock import SessionLock
from tracking.owned_files import read_file

STATE: Final = ".batch.state"
STOP: Final = ".batch.stop"
_PART = f"{STATE}.part"
_WRITE_EVERY_S = 0.5
_MOST_BYTES = 4 << 20
_MOST_WORKERS = 256
_MOST_LEFT = 5000
"""As many recordings as a project lists."""


@dataclass(frozen=True, slots=True)
class WorkedOn:
    """A recording that a worker has.

    Attributes:
        path: of it. stage: what is done with it. share: of the stage, 0 to 1; None: not known.
    """

    path: Path
    stage: str
    share: float | None


@dataclass(frozen=True, slots=True)
class WatchedBatch:
    """A batch at work.

    Attributes:
        total, done, failed, skipped: how many recordings; all zero while it looks for them.
        seconds_left: None while it cannot be told. works: what the workers do.
        left: recordings that have not come to their end, those in work too.
    """

    total: int = 0
    done: int = 0
    failed: int = 0
    skipped: int = 0
    seconds_left: float | None = None
    works: tuple[WorkedOn, ...] = ()
    left: frozenset[Path] = frozenset()

    @property
    def ended(self) -> int:
        """Recordings that came to their end."""
        return self.done + self.failed + self.skipped


class StateFile(Listener):
    """Writes how far a batch is, passes everything on, and interrupts it where it is asked to.

    The file only tells; the ledger is what counts.
    """

    def __init__(self, out: Path, places: Mapping[str, Path], listener: Listener) -> None:
        """Begins; who asked an earlier batch to stop did not mean this one.

        Args:
            out: the output folder. places: of recordings, by their names. listener: told all.
        """
        self._out, self._places, self._listener = out, places, listener
        self._written_s = -_WRITE_EVERY_S
        self.close()

    def close(self) -> None:
        """Take the files away."""
        for name in (STATE, _PART, STOP):
            with contextlib.suppress(OSError):
                (self._out / name).unlink(missing_ok=True)

    def began(self, state: BatchState) -> None:
        """See `Listener`."""
        self._write(state)
        self._listener.began(state)

    def ended(self, name: str, outcome: Outcome) -> None:
        """See `Listener`."""
        self._listener.ended(name, outcome)

    def again(self, name: str, outcome: Outcome) -> None:
        """See `Listener`."""
        self._listener.again(name, outcome)

    def moved(self, state: BatchState) -> None:
        """See `Listener`. Raises KeyboardInterrupt where somebody asked for the end."""
        self._listener.moved(state)
        if time.monotonic() - self._written_s >= _WRITE_EVERY_S:
            self._write(state)
        if os.path.lexists(self._out / STOP):
            raise KeyboardInterrupt

    def _write(self, state: BatchState) -> None:
        self._written_s = time.monotonic()
        part = self._out / _PART
        with contextlib.suppress(OSError):  # nobody can watch then
            part.unlink(missing_ok=True)
            with part.open("x", encoding="utf-8") as file:
                json.dump(self._data(state), file)
            part.replace(self._out / STATE)

    def _data(self, state: BatchState) -> dict[str, Any]:
        works = [
            {"path": str(self._places[one.name]), "stage": one.stage}
            | {"done": one.done, "total": one.total}
            for one in list(state.doing.values())[:_MOST_WORKERS]
            if one.name in self._places
        ]
        counts = {"done": state.done, "failed": state.failed, "skipped": state.skipped}
        told = {"total": state.total, **counts, "seconds_left": state.seconds_left}
        names = islice((name for name in state.left if name in self._places), _MOST_LEFT)
        left = [str(self._places[name]) for name in names]
        return {**told, "works": works, "left": left}


def watch(out: Path) -> WatchedBatch | None:
    """The batch that works in an output folder; None: none does."""
    try:
        if not os.path.lexists(out / LOCK) or not SessionLock(out / LOCK).is_held:
            return None
    except (OSError, SessionError):
        return None
    try:
        return _watched(json.loads(read_file(out / STATE, _MOST_BYTES)))
    except (OSError, SessionError, ValueError, LookupError, TypeError, RecursionError):
        return WatchedBatch()


def ask_to_stop(out: Path) -> None:
    """Ask the batch that works in an output folder to end; it does so within a moment.

    Raises OSError where the folder cannot be written to.
    """
    (out / STOP).touch()


def _watched(said: Mapping[str, Any]) -> WatchedBatch:
    left = said["seconds_left"]
    return WatchedBatch(
        _count(said, "total"),
        _count(said, "done"),
        _count(said, "failed"),
        _count(said, "skipped"),
        None if left is None else max(0.0, float(left)),
        tuple(_worked_on(one) for one in said["works"][:_MOST_WORKERS]),
        frozenset(Path(str(one)) for one in said["left"][:_MOST_LEFT]),
    )


def _count(said: Mapping[str, Any], name: str) -> int:
    return max(0, int(said[name]))


def _worked_on(said: Mapping[str, Any]) -> WorkedOn:
    total = int(said["total"])
    share = min(1.0, max(0.0, int(said["done"]) / total)) if total > 0 else None
    return WorkedOn(Path(str(said["path"])), str(said["stage"])[:80], share)
