"""What a worker is asked to do with a recording, and where it puts what it makes."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from tracking.batch.order import BatchOrder
from tracking.batch.outcome import Outcome
from tracking.batch.recordings import is_name
from tracking.errors import UnsafeFileError
from tracking.owned_files import read_file

HIDDEN = ".batch-"
"""How names of unfinished work begin in the output folder."""
_SESSION, _OUTCOME, _THUMBNAIL, _PAGE, _EXPORTS = (
    *("session.h5", "outcome.json", "thumbnail.jpg", "report", "exports"),
)
MOST_OUTCOME_BYTES = 4 << 20


@dataclass(frozen=True, slots=True)
class Workplace:
    """The hidden places in the output folder that one attempt writes to.

    The session's is right in the output folder, from which it refers to its recording.
    """

    out: Path
    token: str

    @property
    def folder(self) -> Path:
        """For all but the session."""
        return self.out / f"{HIDDEN}{self.token}"

    @property
    def session(self) -> Path:
        """The session that was made."""
        return self.out / f"{HIDDEN}{self.token}.h5"

    @property
    def outcome(self) -> Path:
        """Written last: what stands beside it is whole then."""
        return self.folder / _OUTCOME

    @property
    def thumbnail(self) -> Path:
        """A small image."""
        return self.folder / _THUMBNAIL

    @property
    def page(self) -> Path:
        """The folder of the report on the score."""
        return self.folder / _PAGE

    @property
    def exports(self) -> Path:
        """A folder for each format."""
        return self.folder / _EXPORTS


@dataclass(frozen=True, slots=True)
class Task:
    """One recording for a worker.

    Attributes:
        name, path: see `Entry`. out: the output folder. token: of its `Workplace`.
        order: what is asked for. asked: digest of it, as far as tracking goes.
        known: what became of the recording the last time; None: it is new.
        signature: of its files, as they are before; see `signature_of`.
        memory_bytes: see `Limits`.
    """

    name: str
    path: Path
    out: Path
    token: str
    order: BatchOrder
    asked: str
    signature: str
    known: Outcome | None = None
    memory_bytes: int | None = None

    @property
    def workplace(self) -> Workplace:
        """Where it puts what it makes."""
        return Workplace(self.out, self.token)

    @property
    def session(self) -> Path:
        """Where the session stands in the end."""
        return self.out / f"{self.name}.h5"

    def as_data(self) -> dict[str, Any]:
        """As JSON holds it."""
        return {
            "name": self.name,
            "path": str(self.path),
            "out": str(self.out),
            "token": self.token,
            "order": self.order.as_data(),
            "asked": self.asked,
            "signature": self.signature,
            "known": None if self.known is None else self.known.as_text(),
            "memory_bytes": self.memory_bytes,
        }

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """What `as_data` gave."""
        return cls(
            data["name"],
            Path(data["path"]),
            Path(data["out"]),
            data["token"],
            BatchOrder.from_data(data["order"]),
            data["asked"],
            data["signature"],
            None if data["known"] is None else Outcome.from_text(data["known"]),
            data["memory_bytes"],
        )


@dataclass(frozen=True, slots=True)
class Finished:
    """What a worker leaves on disk when a task is done, so that nobody does it again.

    Attributes:
        name, path, asked: of the task. outcome: what became of it.
    """

    name: str
    path: Path
    asked: str
    outcome: Outcome

    def as_bytes(self) -> bytes:
        """As a file holds it."""
        said = {"name": self.name, "path": str(self.path), "asked": self.asked}
        return json.dumps({**said, "outcome": self.outcome.as_text()}).encode()

    @classmethod
    def read(cls, place: Workplace) -> Self | None:
        """What stands in a workplace; None: nothing, or nothing whole."""
        try:
            said = json.loads(read_file(place.outcome, MOST_OUTCOME_BYTES))
            outcome = Outcome.from_text(str(said["outcome"]))
            name = str(said["name"])
            if not is_name(name):  # it would lead out of the folder
                return None
            return cls(name, Path(said["path"]), str(said["asked"]), outcome)
        except (OSError, UnsafeFileError, ValueError, LookupError, TypeError, RecursionError):
            return None
