"""Files that an export wrote, known again by their content: `export` replaces them without asking.

Exports of the window and of the command line are kept in one record.

A person's state folder holds what was written where, as digests. A file that somebody changed since
is theirs.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Iterable
from pathlib import Path

from platformdirs import user_state_path

from tracking.atomic_output import replacing
from tracking.errors import OutputError

_MOST_FILES = 2000
"""The oldest are forgotten: about 300 kB of names and digests."""
_MOST_BYTES = 4 << 20
"""A larger ledger is not one of ours."""


def remember(files: Iterable[Path]) -> None:
    """Files that were just written. Where nothing can be kept they are asked about next time."""
    known = _known()
    for file in files:
        with contextlib.suppress(OSError):
            if file.is_file():
                known.pop(name := str(file.resolve()), None)
                known[name] = _digest(file)
    with contextlib.suppress(OSError, OutputError):
        _ledger().parent.mkdir(parents=True, exist_ok=True)
        with replacing(_ledger()) as stream:
            json.dump(dict(list(known.items())[-_MOST_FILES:]), stream)


def is_own(path: Path) -> bool:
    """Whether a file is as an export wrote it there."""
    written = _known().get(str(path.resolve()))
    try:
        return written is not None and written == _digest(path)
    except OSError:
        return False


def _known() -> dict[str, str]:
    """Digests by the files' places, the oldest first; none where there is no ledger of ours."""
    try:
        if _ledger().stat().st_size > _MOST_BYTES:
            return {}
        held = json.loads(_ledger().read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        return {}
    return {str(k): str(v) for k, v in held.items()} if isinstance(held, dict) else {}


def _ledger() -> Path:
    return user_state_path("trackwright", appauthor=False) / "exports.json"


def _digest(file: Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
