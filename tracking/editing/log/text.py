"""One side of a change as text and back: what the journal and the session's log hold.

JSON; the values of rows, which must come back bit for bit, as the bytes of one column after the
other, little-endian, compressed with zlib and written in base64.
"""

from __future__ import annotations

import base64
import binascii
import json
import threading
import zlib
from collections import OrderedDict
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.change import Change, State, no_rows, no_stretches
from tracking.editing.log.label_text import labels_as_json, labels_from_json
from tracking.errors import EditError
from tracking.tracks import CORRECTED_COLUMNS, Columns, check_tracks, row_keys
from tracking.translation import msg

LARGEST_TEXT = 2**28
"""Characters: some three million rows that a tracker made."""
LARGEST_ROWS = 20_000_000
_SAMPLE_ROWS = 20_000
_ROW_BYTES = sum(dtype.itemsize for dtype in CORRECTED_COLUMNS.values())
_MOST, _CHARACTERS = 8, 32_000_000
"""Recent states that are kept, and their characters in all: some 500,000 rows."""


def state_as_text(state: State) -> str:
    """The state as JSON; parts that touch nothing are left out.

    Raises EditError where it is too large to be read again.
    """
    count = len(state.rows["frame"])
    if count > LARGEST_ROWS:
        raise _too_large(count)
    parts: dict[str, Any] = {}
    if len(state.stretches):
        parts["stretches"] = state.stretches.tolist()
    if count:
        parts["rows"] = _rows_as_json(state.rows)
    labels = labels_as_json(state.labels)
    if labels:
        parts["labels"] = labels
    text = json.dumps(parts, separators=(",", ":"), default=_plain)
    if len(text) > LARGEST_TEXT:
        raise _too_large(count)
    if count:
        _RECENT.put(text, _as_read(state, labels))
    return text


def _as_read(state: State, labels: Mapping[str, Any]) -> State:
    """The state as its text gives it back, in arrays of its own."""
    types = CORRECTED_COLUMNS.items()
    rows = {name: np.array(state.rows[name], dtype) for name, dtype in types}
    read = labels_from_json(json.loads(json.dumps(labels, default=_plain)))
    return State(np.array(state.stretches, np.int64).reshape(-1, 3), rows, read)


def rows_beyond_the_log(change: Change) -> int:
    """How many rows a change has on a side that the log will not keep; 0 where it will.

    Quick, for changes that are only planned: told from a sample of the rows.
    """
    for side in (change.before, change.after):
        count = len(side.rows["frame"])
        if count > LARGEST_ROWS or _expected_characters(side.rows) > LARGEST_TEXT:
            return count
    return 0


def _expected_characters(rows: Columns) -> float:
    """How long the text of rows will be, from a stretch in their middle."""
    count = len(rows["frame"])
    longest = count * _ROW_BYTES * 4 / 3  # base64 of what cannot be packed
    if longest <= LARGEST_TEXT or count <= _SAMPLE_ROWS:
        return longest
    first = (count - _SAMPLE_ROWS) // 2
    sample = {name: rows[name][first : first + _SAMPLE_ROWS] for name in CORRECTED_COLUMNS}
    return len(_rows_as_json(sample)["columns"]) * count / _SAMPLE_ROWS


def _plain(value: object) -> Any:
    """A number of NumPy's as Python's own, as a caller's arrays give them."""
    if isinstance(value, np.generic):
        return value.item()
    raise EditError(
        "an edit holds {value!r}, which the log cannot keep; give numbers and text", value=value
    )


def _too_large(rows: int) -> EditError:
    return EditError(
        "an edit of {rows} rows is larger than the history can keep; make it in shorter ranges "
        "of frames or with fewer tracks at once",
        rows=rows,
    )


def state_from_text(text: str) -> State:
    """The state a text was made from, not to be written to.

    Raises EditError where it is none, or absurdly large.
    """
    known = _RECENT.get(text)
    if known is None:
        known = _read(text)
        _RECENT.put(text, known)
    return known


def _read(text: str) -> State:
    parts = _parts_of(text)
    try:
        stretches = np.array(parts.get("stretches", no_stretches()), np.int64).reshape(-1, 3)
        rows = _rows_from_json(parts["rows"]) if "rows" in parts else no_rows()
        return State(stretches, rows, labels_from_json(parts.get("labels", {})))
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError, OverflowError) as why:
        raise EditError("an edit in the log cannot be read: {why}", why=why) from why


def stretches_in_text(text: str) -> list[tuple[int, int, int]]:
    """The stretches of a state's text: track, start, end. Raises EditError where it has none."""
    given = _parts_of(text).get("stretches", [])
    try:
        return [(int(track), int(start), int(end)) for track, start, end in given]
    except (ValueError, TypeError, OverflowError) as why:
        raise EditError("an edit in the log cannot be read: {why}", why=why) from why


def cells_in_text(text: str) -> NDArray[np.int64]:
    """(n,) `row_keys` of track and frame of the rows of a state's text, in order of frames.

    Raises EditError where it cannot be read.
    """
    parts = _parts_of(text)
    if "rows" not in parts:
        return np.zeros(0, np.int64)
    try:
        count, plain = _plain_rows(parts["rows"])
    except (ValueError, KeyError, TypeError, AttributeError) as why:
        raise EditError("an edit in the log cannot be read: {why}", why=why) from why
    # The first two columns.
    frame, track = np.frombuffer(plain, "<i4", 2 * count).reshape(2, count).astype(np.int64)
    return row_keys(track, frame)


def _parts_of(text: str) -> dict[str, Any]:
    """A state's text as JSON. Raises EditError where it is none, or absurdly large."""
    if len(text) > LARGEST_TEXT:
        raise EditError(
            "an edit of {count} characters is larger than any real one", count=len(text)
        )
    try:
        parts = json.loads(text)
    except (ValueError, RecursionError) as why:
        raise EditError("an edit in the log cannot be read: {why}", why=why) from why
    if not isinstance(parts, dict):
        raise EditError("an edit in the log cannot be read: it is no JSON object")
    return parts


def _rows_as_json(rows: Columns) -> dict[str, Any]:
    plain = b"".join(
        rows[name].astype(dtype.newbyteorder("<"), copy=False).tobytes()
        for name, dtype in CORRECTED_COLUMNS.items()
    )
    packed = base64.b64encode(_packed(plain)).decode("ascii")
    return {"count": len(rows["frame"]), "columns": packed}


def _packed(plain: bytes) -> bytes:
    """Deflated, looking for runs alone: a third of the time of level 1 for 5 % more bytes."""
    packer = zlib.compressobj(1, strategy=zlib.Z_RLE)
    return packer.compress(plain) + packer.flush()


def _rows_from_json(parts: Mapping[str, Any]) -> Columns:
    count, plain = _plain_rows(parts)
    rows, at = {}, 0
    for name, dtype in CORRECTED_COLUMNS.items():
        column = np.frombuffer(plain, dtype.newbyteorder("<"), count, at)
        rows[name] = column.astype(dtype, copy=False)
        at += column.nbytes
    check_tracks(rows, msg("an edit in the log"))
    return rows


def _plain_rows(parts: Mapping[str, Any]) -> tuple[int, bytes]:
    """How many rows there are, and the bytes of their columns one after the other."""
    count = int(parts["count"])
    if not 0 <= count <= LARGEST_ROWS:
        raise EditError("an edit of {count} rows is larger than any real one", count=count)
    return count, _inflated(str(parts["columns"]), count * _ROW_BYTES)


def _inflated(packed: str, size: int) -> bytes:
    """Exactly size bytes; never inflates more than one beyond."""
    inflater = zlib.decompressobj()
    try:
        plain = inflater.decompress(base64.b64decode(packed, validate=True), size + 1)
    except (binascii.Error, zlib.error) as why:
        raise EditError("the rows of an edit in the log are damaged: {why}", why=why) from why
    if len(plain) != size or not inflater.eof:
        raise EditError("the rows of an edit in the log are damaged: not {size} bytes", size=size)
    return plain


class RecentStates:
    """A few states, so that an edit of a whole track is not unpacked again while it is made.

    Whoever is given one must not write into its arrays. Used from any thread.
    """

    def __init__(self) -> None:
        """None is known."""
        self._states: OrderedDict[str, State] = OrderedDict()
        self._lock = threading.Lock()

    def get(self, text: str) -> State | None:
        """The state of a text, where it is known."""
        if len(text) > _CHARACTERS:
            return None
        with self._lock:
            state = self._states.get(text)
            if state is not None:
                self._states.move_to_end(text)
        return state

    def put(self, text: str, state: State) -> None:
        """Know the state a text stands for, and forget the one asked for longest ago."""
        if len(text) > _CHARACTERS:
            return
        for array in (state.stretches, *state.rows.values()):
            array.flags.writeable = False
        with self._lock:
            self._states[text] = state
            self._states.move_to_end(text)
            while len(self._states) > _MOST or sum(map(len, self._states)) > _CHARACTERS:
                self._states.popitem(last=False)


_RECENT = RecentStates()
