"""Whether files may have changed, told without reading them."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

_STATE = "{} {} {} {}\n"


def signature(places: Iterable[Path], leave_out: Path | None = None) -> str:
    """A digest over names, sizes and times of the files at places, as hex.

    The same signature means the same files: the time of the last change of a file's state, which
    no program can set, is in it. Another one means only that they must be looked at.

    Args:
        places: files, and folders with all that is in them; what is missing counts as missing.
        leave_out: a folder in them that does not count.
    """
    digest = hashlib.sha256()
    hidden = None if leave_out is None else os.path.realpath(leave_out)
    for place in places:
        for line in _states(os.fspath(place), hidden):
            digest.update(line.encode("utf-8", "surrogateescape"))
    return digest.hexdigest()


def signature_of(
    path: Path, boxes: Iterable[Path], outside: Iterable[Path], leave_out: Path
) -> str:
    """The signature of a recording, its files of boxes, and its files in other folders."""
    return signature((path, *boxes, *outside), leave_out)


def file_state(path: Path) -> tuple[int, int, int] | None:
    """Size in bytes, and the times of the last change of content and state, ns; None: missing."""
    try:
        state = path.lstat()
    except OSError:
        return None
    return state.st_size, state.st_mtime_ns, state.st_ctime_ns


def _states(place: str, hidden: str | None) -> Iterator[str]:
    try:
        state = os.stat(place)  # noqa: PTH116 - quick, and for many files
    except OSError:
        yield f"{place} missing\n"
        return
    yield _STATE.format(place, state.st_size, state.st_mtime_ns, state.st_ctime_ns)
    try:
        with os.scandir(place) as held:
            inside = sorted(held, key=lambda each: each.name)
    except OSError:  # a file
        return
    for each in inside:
        if each.is_dir(follow_symlinks=False):
            if hidden is None or os.path.realpath(each.path) != hidden:
                yield from _states(each.path, hidden)
            continue
        try:
            state = each.stat()
        except OSError:
            yield f"{each.path} missing\n"
            continue
        yield _STATE.format(each.path, state.st_size, state.st_mtime_ns, state.st_ctime_ns)
