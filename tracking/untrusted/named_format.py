"""What HDF5 files say they are: `python named_format.py FILE...`.

See `program` for why this is a program of its own. It reads one short text, the root attribute
`format`, and prints {"format": text} a file, "" where there is none.
"""

from __future__ import annotations

from pathlib import Path

import h5py

from tracking.untrusted.program import say_verdicts, verdicts_of

_LONGEST_BYTES = 256
"""Of the attribute's own bytes; those of this program take 25 at most, or 16 that lead to them."""
_KEY = "format"


def format_named(path: Path) -> str:
    """What the file says it is. Raises whatever the library does on a damaged file."""
    with h5py.File(path, "r", locking=False) as file:
        if _KEY not in file.attrs:
            return ""
        attribute = file.attrs.get_id(_KEY)
        is_text = h5py.check_string_dtype(attribute.dtype) is not None
        is_one = attribute.shape == () and attribute.get_storage_size() <= _LONGEST_BYTES
        return str(file.attrs[_KEY])[:_LONGEST_BYTES] if is_text and is_one else ""


def named_format(path: Path) -> str:
    """What an HDF5 file from anywhere says it is, asked by a program of its own; "": nothing."""
    return str(verdicts_of(__file__, "HDF5", [path])[0].get(_KEY, ""))


if __name__ == "__main__":
    say_verdicts(format_named, _KEY)
