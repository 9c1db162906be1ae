"""Numbers as text, thousands at once.

Python writes a million numbers a second one by one; a table of tracks has ten a row. Here a column
becomes a block of bytes with room for the longest number, filled by whole-number arithmetic on
arrays; bytes that are not needed are 0, and are taken out of the finished lines all at once.

A number is written with as few digits as it takes to read back exactly the same one, as `repr`
does, never with an exponent where it is of a size that tracks have.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

Block = NDArray[np.uint32]
"""(n, words) a column as characters, four to a word, 0 where there is none; the first word has room
for what divides columns in its first byte, and for the sign in its second."""

Whole = NDArray[np.int64]

_LEAST, _MOST = 2.0**-7, 1e8
"""Between these, and at 0, 60 bits hold all of a fraction and two words all whole digits."""

_DECIMALS = 18
_BITS, _LOW = 30, (1 << 30) - 1
_BILLION = 10**9
_FRACTION_WORDS, _WHOLE_WORDS = 5, 2
_FIELD_WORDS = 1 + _WHOLE_WORDS + _FRACTION_WORDS
_MINUS = np.uint32(ord("-") << 8)
_NOTHING = np.uint32(0)


def lines_of(blocks: Sequence[Block], separator: bytes = b",") -> bytes:
    """The rows of some columns as lines, divided by one character, each with its end."""
    used = [_used_words(block) for block in blocks]
    text = np.empty((len(blocks[0]), sum(map(len, used)) + len(blocks) + 1), np.uint32)
    at = 0
    for block, places in zip(blocks, used, strict=True):
        text[:, at] = block[:, 0] | (separator[0] if at else 0)
        for word, place in enumerate(places, at + 1):
            text[:, word] = block[:, place]
        at += 1 + len(places)
    text[:, at] = ord("\n")
    return text.tobytes().translate(None, b"\0")


def _used_words(block: Block) -> list[int]:
    """The words behind the first that hold anything in any row."""
    return [at for at in range(1, block.shape[1]) if block[:, at].max(initial=0)]


def whole_numbers(values: NDArray[Any]) -> Block:
    """Whole numbers; at most twelve digits, of any sign."""
    size = np.abs(values).astype(np.int64)
    words = 2 if int(size.max(initial=0)) < 10**8 else 3
    block = np.empty((len(size), 1 + words), np.uint32)
    block[:, 0] = np.where(values < 0, _MINUS, _NOTHING)
    groups = [(size // 10 ** (4 * at)) % 10_000 for at in reversed(range(words))]
    _put_whole(block[:, 1:], groups)
    return block


def constant(text: bytes, rows: int) -> Block:
    """The same few characters in every row."""
    return chosen([text], np.zeros(rows, np.int64))


def chosen(texts: Sequence[bytes], which: NDArray[Any]) -> Block:
    """One of a few texts in each row, by its number."""
    longest = -(-max(map(len, texts)) // 4) * 4
    padded = b"".join(b"\0\0\0\0" + text.ljust(longest, b"\0") for text in texts)
    block: Block = np.frombuffer(padded, np.uint32).reshape(len(texts), -1)[which]
    return block


def numbers(values: NDArray[Any], unknown: bytes) -> Block:
    """Numbers with every digit they need, NaN as the given text."""
    values = np.asarray(values, np.float64)
    missing = np.isnan(values)
    if missing.all():
        return constant(unknown, len(values))
    size = np.abs(values)
    if not missing.any() and bool(((size < _MOST) & (size == np.rint(size))).all()):
        return whole_numbers(values)
    by_rule = (size == 0) | ((size >= _LEAST) & (size < _MOST))
    block = _by_rule(np.where(by_rule, size, 0.0), values < 0)
    if missing.any():
        _overwrite(block, missing, unknown)
    for row in np.flatnonzero(~by_rule & ~missing).tolist():
        _overwrite(block, row, repr(float(values[row])).removesuffix(".0").encode())
    return block


def short_decimals(values: NDArray[np.float32]) -> Floats:
    """32-bit numbers as the 64-bit ones of the fewest digits that are the same with 32 bits."""
    wide = values.astype(np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        power = np.floor(np.log10(np.abs(wide)))
    power = np.where(np.isfinite(power), power, 0.0)
    short, open_rows = wide.copy(), np.arange(len(wide))
    for digits in range(6, 9):
        scale = 10.0 ** np.clip(digits - 1 - power[open_rows], 0, 22)
        tried = np.rint(wide[open_rows] * scale) / scale
        same = tried.astype(np.float32) == values[open_rows]
        short[open_rows[same]] = tried[same]
        open_rows = open_rows[~same]
    return short


def _by_rule(size: Floats, negative: NDArray[np.bool_]) -> Block:
    """Numbers that are 0 or between `_LEAST` and `_MOST`."""
    whole = size.astype(np.int64)
    fraction = _rounded(size, *_digits_of(size - whole))
    carried = fraction == 10**_DECIMALS
    whole, fraction = whole + carried, np.where(carried, 0, fraction)
    block = np.empty((len(size), _FIELD_WORDS), np.uint32)
    block[:, 0] = np.where(negative, _MINUS, _NOTHING)
    _put_whole(block[:, 1:3], np.divmod(whole.astype(np.int32), np.int32(10_000)))
    _put_fraction(block[:, 3:], fraction)
    return block


def _digits_of(fraction: Floats) -> tuple[Whole, Whole, Floats]:
    """The first nine decimals, the next nine, and what is left of a unit of the last one.

    Exact: a fraction is a whole number of 2**-60, which is multiplied in two halves of 30 bits.
    """
    bits = (fraction * 2.0**60).astype(np.int64)
    high, low = bits >> _BITS, bits & _LOW
    nines: list[Whole] = []
    for _ in range(2):
        low *= _BILLION
        high = high * _BILLION + (low >> _BITS)
        low &= _LOW
        nines.append(high >> _BITS)
        high &= _LOW
    return nines[0], nines[1], np.asarray(high * 2.0**-_BITS, np.float64)


def _rounded(size: Floats, first: Whole, second: Whole, rest: Floats) -> Whole:
    """The fraction in units of 10**-18, rounded as far as the number stays the same."""
    exponent = np.frexp(size)[1] + 6  # 2**-7 is the first
    room, step = _ROOM[exponent], _STEP[exponent]
    # Most numbers that are short have at most nine decimals, which is quick to tell.
    up = second >= _BILLION // 2
    rounded: Whole = (first + up) * _BILLION
    off = np.abs(second + rest - up * _BILLION)
    longer = np.flatnonzero((off >= room) | (step >= _BILLION))
    digits = first[longer] * _BILLION + second[longer]
    rounded[longer] = _shortest(digits, rest[longer], room[longer], step[longer])
    return rounded


def _shortest(digits: Whole, rest: Floats, room: Floats, step: Whole) -> Whole:
    """Numbers rounded to the largest power of ten that is near enough; the step given is."""
    shortest = np.empty_like(digits)
    for power in _POWERS:
        rows = np.flatnonzero(step == power)
        if len(rows):  # dividing by one number is several times quicker than by each its own
            shortest[rows] = _shortest_from(digits[rows], rest[rows], room[rows], power)
    return shortest


def _shortest_from(digits: Whole, rest: Floats, room: Floats, step: int) -> Whole:
    """The same for numbers that have one step."""
    shortest = _to_step(digits, rest, step)
    tried = np.arange(len(digits))
    while len(tried) and (step := step * 10) < 10**_DECIMALS:
        rounded = _to_step(digits, rest, step)
        near = np.flatnonzero(np.abs(digits - rounded + rest) < room)
        shortest[tried[near]] = rounded[near]
        tried, digits, rest, room = tried[near], digits[near], rest[near], room[near]
    return shortest


def _to_step(digits: Whole, rest: Floats, step: int) -> Whole:
    """Rounded to multiples of a step; what lies just between two goes to the even one."""
    times = digits // step
    if step == 1:
        up = (rest > 0.5) | ((rest == 0.5) & (times & 1 == 1))
    else:
        over = 2 * (digits - times * step) - step
        up = (over > 0) | ((over == 0) & ((rest > 0) | (times & 1 == 1)))
    rounded: Whole = (times + up) * step
    return rounded


def _put_whole(block: Block, groups: Sequence[NDArray[Any]]) -> None:
    """Whole digits, four to a group, without leading noughts."""
    begun = np.zeros(len(block), np.bool_)
    for at, group in enumerate(groups):
        block[:, at] = np.where(begun, _FOUR[group], _UNPADDED[group])
        begun |= group > 0
    last, nought = block[:, -1], ~begun
    last[nought] = ord("0")


def _put_fraction(block: Block, fraction: Whole) -> None:
    """The point and the decimals, without noughts at the end; nothing where there are none."""
    begin, rest = np.divmod(fraction, 10**15)
    upper, lower = np.divmod(rest * 10, 10**8)
    groups: list[NDArray[Any]] = []
    for half in (upper.astype(np.int32), lower.astype(np.int32)):
        groups += np.divmod(half, np.int32(10_000))
    follows = np.zeros(len(block), np.bool_)
    for at, group in reversed(list(enumerate(groups, 1))):
        block[:, at] = np.where(follows, _FOUR[group], _UNTRAILED[group])
        follows |= group > 0
    block[:, 0] = np.where(follows, _POINT_AND_THREE[begin], _POINT_UNTRAILED[begin])


def _overwrite(block: Block, rows: Any, text: bytes) -> None:
    """Other text in some rows."""
    block[rows] = 0
    block.view(np.uint8)[rows, 4 : 4 + len(text)] = np.frombuffer(text, np.uint8)


def _words(texts: Sequence[str]) -> Block:
    return np.frombuffer(b"".join(text.encode().ljust(4, b"\0") for text in texts), np.uint32)


_FOUR = _words([f"{number:04d}" for number in range(10_000)])
_UNPADDED = _words(["", *(f"{number}" for number in range(1, 10_000))])
_UNTRAILED = _words([f"{number:04d}".rstrip("0") for number in range(10_000)])
_POINT_AND_THREE = _words([f".{number:03d}" for number in range(1000)])
_POINT_UNTRAILED = _words(["", *(f".{number:03d}".rstrip("0") for number in range(1, 1000))])

# By the exponent of 2 a number has: how far, in units of 10**-18, a text may be off it and still
# be read back as it, and a power of ten to which any such number may be rounded.
_ROOM = np.array([10**18 * 2.0 ** (exponent - 54) for exponent in range(-6, 29)])
_STEP = np.array([10 ** max(len(str(int(2 * room))) - 1, 0) for room in _ROOM], np.int64)
_POWERS = tuple(sorted(set(_STEP.tolist())))
