"""HDF5 files of other tools, looked over by a program of its own before they are opened."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tracking.errors import FormatError, explain_unreadable
from tracking.formats import hdf5_tracks_inspection
from tracking.formats.read_result import FASTEST_FPS
from tracking.translation import Message, msg
from tracking.untrusted import SIGNATURE, verdicts_of


def has_layout(*layouts: str) -> Callable[[Path, bytes], bool]:
    """Says of a file whether it is HDF5 of one of these layouts."""

    def recognises(path: Path, head: bytes) -> bool:
        if not head.startswith(SIGNATURE):
            return False
        try:
            return _verdict(path).get("layout") in layouts
        except OSError:
            return False

    return recognises


def why_refused(path: Path) -> Message:
    """Why a HDF5 file is of no layout read here, as it goes on after the file's name; "": it is.

    Raises OSError where the file is not there.
    """
    return msg(_verdict(path).get("refused", ""))


@contextmanager
def opened(path: Path, *layouts: str) -> Iterator[h5py.File]:
    """The file, if it is safe and of one of these layouts.

    Raises FormatError where it is not, and for what the library says of damage while it is read.
    """
    with explain_unreadable(path):
        verdict = _verdict(path)
    if "refused" in verdict:
        raise FormatError("{path}{why}", path=path, why=verdict["refused"])
    if verdict["layout"] not in layouts:
        raise FormatError(
            "{path} is a file of {layout}",
            "import it as that",
            option="--format",
            path=path,
            layout=verdict["layout"],
        )
    try:
        with h5py.File(path, "r", locking=False) as file:
            yield file
    except (OSError, KeyError, ValueError, TypeError, RuntimeError, OverflowError) as error:
        raise FormatError(
            "{path} is damaged: its tracks cannot be read; export it anew", path=path
        ) from error


def number_of(node: h5py.Group | h5py.Dataset, name: str) -> float | None:
    """An attribute that is one finite number above 0; None where it is not."""
    value = node.attrs.get(name)
    if value is None or np.size(value) != 1 or np.asarray(value).dtype.kind not in "iuf":
        return None
    number = float(np.asarray(value).item())
    return number if 0 < number < FASTEST_FPS else None


def text_of(value: Any) -> str:
    """A name as h5py gives it."""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def _verdict(path: Path) -> dict[str, Any]:
    """Raises OSError where the file is not there."""
    now = path.stat()
    return _verdict_on(path, now.st_size, now.st_mtime_ns)


@lru_cache(maxsize=8)
def _verdict_on(path: Path, _size: int, _modified_ns: int) -> dict[str, Any]:
    return verdicts_of(hdf5_tracks_inspection.__file__, "tracks", [path])[0]
