"""JSON from elsewhere, an element at a time: a file of any size is never in memory as a whole.

What a bomb needs is what is capped here: the bytes of the file, the length of one element, and,
by the parser's own limits, how deep it nests and how many digits its numbers have.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from io import BytesIO, TextIOWrapper
from pathlib import Path
from typing import Any, BinaryIO, TextIO

from tracking.errors import FormatError, explain_unreadable
from tracking.progress import Progress, no_progress
from tracking.translation import joined, msg

JsonPath = tuple[str | int, ...]
"""Where a value stands in a file: names of members, and elements of arrays from 0."""

MOST_BYTES = 4 << 30
"""So much the longest sessions take: a box has 100 to 200 bytes. Nothing of the file is held; where
it is none of these, what it holds is capped much earlier."""
LONGEST_ELEMENT = 4 << 20
"""Characters; an outline of a person drawn with every pixel is far shorter."""

_PIECE = 1 << 20
_TEXT_PART = re.compile(r'[^"\\]*+(?:\\.[^"\\]*+)*+', re.DOTALL)
"""What of a text is held, but for a backslash whose other half is not."""
_SPACE = re.compile(r"[ \t\r\n]*")
_MOST_PASSED_OVER = 100_000
"""Elements of members that are not wanted."""
_MOST_MEMBERS = 10_000
"""Of one object that is entered, which has tens."""
_TAIL = 1 << 16
"""Bytes at the end, which tell a file that was cut short before all of it is read."""
_ENDS = (b"}", b"]")
_BETWEEN = "},"
_SOME = 1000
"""So many elements are read one by one where they could not be read together."""


def elements_of(
    path: Path,
    wanted: Collection[str],
    report: Progress = no_progress,
    held: bytes | None = None,
) -> Iterator[tuple[str, int, Any]]:
    """What the members of a file's one object hold: the name, and from 0 each element of an array.

    Args:
        path: of a file that holds one object.
        wanted: names of members; others are passed over. A member that is no array comes whole,
            as element -1.
        report: called with bytes.
        held: what the file holds, where it has been read.

    Raises FormatError where the file is missing, too large, no such JSON, or an element is too
    long or too deep.
    """
    with _opened(path, report, held) as text:
        yield from text.members(wanted)


def values_of(
    path: Path,
    inside: Callable[[JsonPath], bool],
    report: Progress = no_progress,
    held: bytes | None = None,
) -> Iterator[tuple[JsonPath, Any]]:
    """The values of a file with where each stands: names of members, and elements from 0.

    Args:
        path: of a file that holds one object or array.
        inside: whether an object or array at a place is entered, so that its members come one by
            one; all others come whole. It decides how deep is entered, so it must end somewhere.
        report: called with bytes.
        held: what the file holds, where it has been read.

    Raises FormatError as `elements_of`.
    """
    with _opened(path, report, held) as text:
        yield from text.values((), inside)


@contextmanager
def _opened(path: Path, report: Progress, held: bytes | None) -> Iterator[_Text]:
    try:
        with explain_unreadable(path):
            size = path.stat().st_size if held is None else len(held)
            if size > MOST_BYTES:
                raise FormatError(
                    "{path} is larger than {size} GB; split it first",
                    path=path,
                    size=MOST_BYTES >> 30,
                )
            opened: BinaryIO = path.open("rb") if held is None else BytesIO(held)
            with opened, TextIOWrapper(opened, encoding="utf-8-sig") as stream:
                _check_end(path, opened, size)
                yield _Text(path, stream, lambda: report(min(opened.tell(), size), size))
    except UnicodeDecodeError as error:
        raise FormatError("{path} is not text; give a JSON file", path=path) from error


def _check_end(path: Path, held: BinaryIO, size: int) -> None:
    """Refuse a long file that ends within; held is at its beginning, and is so again."""
    if size > _TAIL:
        held.seek(size - _TAIL)
        if not held.read(_TAIL).rstrip(b" \t\r\n\0").endswith(_ENDS):
            raise FormatError(
                "{path} is cut short: it ends within its JSON; export it again", path=path
            )
        held.seek(0)


class _Text:
    """A file's text, of which a little is held."""

    def __init__(self, path: Path, stream: TextIO, read_on: Callable[[], None]) -> None:
        """read_on: called after each piece."""
        self._path, self._stream, self._read_on = path, stream, read_on
        self._held, self._at, self._before = "", 0, 0
        self._decoder = json.JSONDecoder(parse_constant=_unknown)
        self._decode = self._decoder.decode
        self._one_by_one = 0

    def members(self, wanted: Collection[str]) -> Iterator[tuple[str, int, Any]]:
        """See `elements_of`."""
        self._take("{")
        if self._sign() == "}":
            return
        for name in self._names():
            if name not in wanted and self._sign() == '"':
                self._pass_over_text()
            else:
                yield from self._wanted(name, wanted)

    def _names(self) -> Iterator[str]:
        """The names of an object that has some; its values are to be taken between them."""
        for _ in range(_MOST_MEMBERS):
            name = self._value()
            if not isinstance(name, str):
                raise self._wrong(msg("a name is missing"))
            self._take(":")
            yield name
            if self._take(",", "}") == "}":
                return
        raise self._wrong(msg("an object has more members than any of these files'"))

    def values(
        self, place: JsonPath, inside: Callable[[JsonPath], bool]
    ) -> Iterator[tuple[JsonPath, Any]]:
        """See `values_of`."""
        sign = self._sign()
        if sign not in ("{", "[") or not inside(place):
            yield place, self._value()
        elif sign == "{":
            yield from self._members_of(place, inside)
        else:
            yield from self._elements_of(place, inside)

    def _members_of(
        self, place: JsonPath, inside: Callable[[JsonPath], bool]
    ) -> Iterator[tuple[JsonPath, Any]]:
        self._take("{")
        if self._sign() == "}":
            self._take("}")
            return
        for name in self._names():
            yield from self.values((*place, name), inside)

    def _elements_of(
        self, place: JsonPath, inside: Callable[[JsonPath], bool]
    ) -> Iterator[tuple[JsonPath, Any]]:
        if not inside((*place, 0)):
            for at, value in self._elements():
                yield (*place, at), value
            return
        self._take("[")
        if self._sign() == "]":
            self._take("]")
            return
        at = 0
        while True:
            yield from self.values((*place, at), inside)
            at += 1
            if self._take(",", "]") == "]":
                return

    def _wanted(self, name: str, wanted: Collection[str]) -> Iterator[tuple[str, int, Any]]:
        """The elements of the member that comes next, where it is wanted."""
        for at, value in self._elements():
            if name in wanted:
                yield name, at, value
            elif at > _MOST_PASSED_OVER:
                raise self._wrong(
                    msg("{name!r} has more elements than any of these files", name=name[:40])
                )

    def _pass_over_text(self) -> None:
        """Pass over a text of any length, such as a picture that stands in the file."""
        self._take('"')
        while True:
            passed = _TEXT_PART.match(self._held, self._at)
            self._at = passed.end() if passed else self._at
            if self._held[self._at : self._at + 1] == '"':
                self._at += 1
                return
            if not self._more():
                raise self._wrong("")

    def _elements(self) -> Iterator[tuple[int, Any]]:
        """The elements of the array that comes next, or the value that does as element -1."""
        if self._sign() != "[":
            yield -1, self._value()
            return
        self._take("[")
        if self._sign() == "]":
            self._take("]")
            return
        at = 0
        while True:
            for value in self._values():
                yield at, value
                at += 1
            if self._take(",", "]") == "]":
                return

    def _values(self) -> list[Any]:
        """The next elements of an array, many at once where they are objects of a usual length.

        What is held is cut behind the last object in it that a comma follows. Where that comma is
        not the array's own, there is no JSON before it: then elements are read one by one.
        """
        if self._sign() != "{" or self._one_by_one:
            self._one_by_one -= self._one_by_one > 0
            return [self._value()]
        cut = self._held.rfind(_BETWEEN, self._at)
        try:
            values: list[Any] = self._decode(f"[{self._held[self._at : cut + 1]}]")
        except (ValueError, RecursionError):
            values = []
        if cut < 0 or not values:
            self._one_by_one = _SOME
            return [self._value()]
        self._at = cut + 1
        return values

    def _sign(self) -> str:
        """The next character that is no space; "" at the end."""
        passed = 0
        while True:
            spaces = _SPACE.match(self._held, self._at)
            end = spaces.end() if spaces else self._at
            passed, self._at = passed + end - self._at, end
            if end < len(self._held):
                return self._held[end]
            if passed > LONGEST_ELEMENT:
                raise self._wrong(msg("there is nothing but spaces"))
            if not self._more():
                return ""

    def _take(self, *signs: str) -> str:
        """Pass over one of these."""
        sign = self._sign()
        if sign not in signs:
            raise self._wrong(
                msg("{sign!r} stands where {signs} belongs", sign=sign, signs=joined(" or ", signs))
                if sign
                else ""
            )
        self._at += 1
        return sign

    def _value(self) -> Any:
        self._sign()
        while True:
            try:
                value, end = self._decoder.raw_decode(self._held, self._at)
            except json.JSONDecodeError as error:
                if len(self._held) - self._at > LONGEST_ELEMENT:
                    raise self._wrong(msg("an element is longer than any of a person")) from error
                if not self._more():
                    raise self._wrong(error.msg) from error
                continue
            except RecursionError as error:
                raise self._wrong(msg("it is nested deeper than any of these files")) from error
            except ValueError as error:  # a number of thousands of digits
                raise self._wrong(msg("a number is longer than any")) from error
            # A number at the end of what is held may go on.
            if end < len(self._held) or not self._more():
                self._at = end
                return value

    def _more(self) -> bool:
        """Hold the next piece, too; False at the end of the file."""
        piece = self._stream.read(_PIECE)
        self._read_on()
        self._before += self._at
        self._held, self._at = self._held[self._at :] + piece, 0
        return bool(piece)

    def _wrong(self, reason: str) -> FormatError:
        where = self._before + self._at
        return FormatError(
            "{path}, character {where}: {reason}; it is not the JSON it should be, export it again",
            path=self._path,
            where=where,
            reason=reason or msg("the file ends"),
        )


def _unknown(_name: str) -> None:
    """NaN and its like are no JSON: a value that is none."""
