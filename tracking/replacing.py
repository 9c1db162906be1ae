"""Output files that appear whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO, TextIO

from tracking.errors import OutputError


def replace_with(path: Path, data: bytes) -> None:
    """Have the bytes at `path`, whole or not at all; what stood there before stays until then.

    Raises OutputError as `replacing`.
    """
    with part_of(path) as part, part.open("wb") as stream:
        stream.write(data)
        stream.flush()
        os.fsync(stream.fileno())


@contextmanager
def replacing(path: Path) -> Iterator[TextIO]:
    """A text file that takes the place of `path` when the block ends without an error.

    Until then everything goes to a hidden file beside it, which is removed when the block is left
    by an error or an interruption; what stood at `path` before stays as it was.

    Raises:
        OutputError: the folder is missing or not writable, the disk is full, `path` is a folder.
    """
    with (
        part_of(path) as part,
        part.open("w", encoding="utf-8", newline="\n") as stream,
    ):
        yield stream
        stream.flush()
        os.fsync(stream.fileno())


@contextmanager
def replacing_bytes(path: Path) -> Iterator[BinaryIO]:
    """A file of bytes that takes the place of `path` in the end; see `replacing`."""
    with part_of(path) as part, part.open("wb") as stream:
        yield stream
        stream.flush()
        os.fsync(stream.fileno())


@contextmanager
def part_of(path: Path) -> Iterator[Path]:
    """The hidden file beside `path` that takes its place in the end; see `replacing`.

    For libraries that write a file of their own; it is there already, and empty.
    """
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".part", dir=path.parent)
    except OSError as error:
        raise _told(path, error) from error
    os.close(handle)
    part = Path(name)
    try:
        yield part
        part.chmod(0o666 & ~_umask())
        part.replace(path)
    except OSError as error:
        raise _told(path, error) from error
    finally:
        part.unlink(missing_ok=True)


def _umask() -> int:
    """The process's mask for new files; can only be read by setting it."""
    mask = os.umask(0o077)
    os.umask(mask)
    return mask


def _told(path: Path, error: OSError) -> OutputError:
    """The system's complaint as one line about the file the user asked for."""
    reason = error.strerror or str(error)
    return OutputError(f"cannot write {path}: {reason}; choose another place with -o")
