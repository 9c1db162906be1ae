"""Memory that is free goes back to the system, where the C library is glibc.

glibc keeps freed blocks of up to 32 MiB for later and has a heap for each thread: pictures read in
one thread and let go in another leave holes that the process keeps (1.1 GiB after 40 recordings
opened and closed, of which 0.3 GiB were in use).
"""

from __future__ import annotations

import ctypes
import gc
from functools import cache

_MMAP_THRESHOLD = -3
"""M_MMAP_THRESHOLD of malloc.h."""
_LARGE_BYTES = 256 << 10
"""Blocks from here on are mapped alone, and unmapped when freed: one picture of VGA has 900 KiB.
Once it is told, glibc no longer moves the threshold up."""


def map_large_blocks() -> None:
    """Have large blocks go back to the system as soon as they are freed."""
    if (library := _glibc()) is not None:
        library.mallopt(_MMAP_THRESHOLD, _LARGE_BYTES)


def give_back() -> None:
    """Collect garbage, then give back what of the heaps is free."""
    gc.collect()
    if (library := _glibc()) is not None:
        library.malloc_trim(0)


@cache
def _glibc() -> ctypes.CDLL | None:
    """The C library; None where it is another one."""
    try:
        library = ctypes.CDLL(None)
        _ = library.malloc_trim, library.mallopt
    except (AttributeError, OSError, TypeError):  # musl, macOS, Windows
        return None
    return library
