"""Knowing a source again without reading all of it."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import RecordingError

_MIB = 1024 * 1024


@dataclass(frozen=True, slots=True)
class Fingerprint:
    """Enough of a source to know it again after it was moved.

    Attributes:
        source: the source as the manifest names it.
        size_bytes: size of the file, or of all images together.
        sha256: hash, in hex, of the first and the last MiB.
    """

    source: str
    size_bytes: int
    sha256: str


def fingerprint(source: str, files: Sequence[Path]) -> Fingerprint:
    """Size, and a hash of the first and the last MiB of a source.

    For images these are the first MiB of the first and the last MiB of the last image, and the
    hash takes in their number.

    Raises:
        RecordingError: a file has gone.
    """
    digest = hashlib.sha256()
    try:
        sizes = [file.stat().st_size for file in files]
        with files[0].open("rb") as opened:
            digest.update(opened.read(_MIB))
        with files[-1].open("rb") as opened:
            opened.seek(max(0, sizes[-1] - _MIB))
            digest.update(opened.read(_MIB))
    except OSError as error:
        raise RecordingError(
            "{path}: cannot be read any more ({reason}); put it back",
            path=error.filename,
            reason=error.strerror,
        ) from error
    if len(files) > 1:
        digest.update(str(len(files)).encode())
    return Fingerprint(source, sum(sizes), digest.hexdigest())
