"""XML from elsewhere, an element at a time, without anything a bomb needs.

No document type, no entities, nothing outside the file; elements nest a few deep, and one element's
text and attributes are short. Nothing of the file is kept but what the caller keeps.
"""

from __future__ import annotations

import re
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import IO, Protocol
from xml.parsers.expat import XMLParserType
from xml.sax import SAXException, SAXParseException
from xml.sax.handler import ContentHandler

from defusedxml import DefusedXmlException
from defusedxml.expatreader import DefusedExpatParser

from tracking.errors import FormatError, explain_unreadable
from tracking.progress import Progress, no_progress
from tracking.translation import msg

MOST_BYTES = 4 << 30
"""So much the longest sessions take: a box has 100 to 200 bytes. Nothing of the file is held."""
_TAIL = 1 << 16
"""Bytes at the end, which tell a file that was cut short before all of it is read."""
_NAME = re.compile(rb"[A-Za-z_][\w.:-]*")
_PIECE = 1 << 18
_DEEPEST = 32
_LONGEST = 1 << 16
"""Characters of one element's text."""
_LONGEST_ELEMENT = 1 << 19
"""Bytes of one element's name and attributes."""
ZIP = b"PK\x03\x04"


class Elements(Protocol):
    """Takes elements as they come."""

    def start(self, name: str, attributes: Mapping[str, str], line: int) -> None:
        """An element begins, on that line of the file."""

    def end(self, name: str, text: str) -> None:
        """An element ends; text: what stood in it, if no other element did."""


def parse(path: Path, elements: Elements, member: str, report: Progress = no_progress) -> None:
    """Go through a file once.

    Args:
        path: of the XML, or of a ZIP archive that holds it.
        member: its name there.
        report: called with bytes of the XML.

    Raises FormatError where the file is missing, too large, no XML, or holds what is not taken;
    what `elements` raises is passed on.
    """
    parser = _Parser(path, elements)
    with _explained(path):
        opened, size = _opened(path, member)
        with opened as stream:
            read = 0
            while piece := stream.read(_PIECE):
                read += len(piece)
                if read > MOST_BYTES:
                    raise FormatError(
                        "{path} is larger than {size} GB; split it first",
                        path=path,
                        size=MOST_BYTES >> 30,
                    )
                parser.feed(piece)
                parser.check_waiting(read)
                report(min(read, size), size)
            if not read:
                raise FormatError("{path} is empty; export it again", path=path)
            parser.close()


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """What makes a file no XML that is taken, as a FormatError."""
    try:
        with explain_unreadable(path):
            yield
    except DefusedXmlException as error:
        raise FormatError(
            "{path} declares a document type or entities; remove them", path=path
        ) from error
    except SAXParseException as error:
        reason = msg(
            "{path}, line {line}: no XML ({reason})",
            path=path,
            line=error.getLineNumber(),
            reason=error.getMessage(),
        )
        raise FormatError("{reason}; export it again", reason=reason) from error
    except (SAXException, UnicodeError, LookupError) as error:
        raise FormatError(
            "{path} is no XML that can be read; export it again", path=path
        ) from error
    except (zipfile.BadZipFile, zlib.error, EOFError) as error:
        raise FormatError(
            "{path} is an archive that is damaged; export it again", path=path
        ) from error


def _opened(path: Path, member: str) -> tuple[AbstractContextManager[IO[bytes]], int]:
    """The XML, and how many bytes it is said to have."""
    with path.open("rb") as stream:
        if stream.read(len(ZIP)) != ZIP:
            size = path.stat().st_size
            if size > _TAIL:
                stream.seek(0)
                head = stream.read(_TAIL)
                stream.seek(size - _TAIL)
                if not _is_ended(head, stream.read(_TAIL)):
                    raise FormatError(
                        "{path} is cut short: it ends within its XML; export it again", path=path
                    )
            return path.open("rb"), size
    try:
        archive = zipfile.ZipFile(path)
        return archive.open(member), archive.getinfo(member).file_size
    except (KeyError, zipfile.BadZipFile, NotImplementedError, RuntimeError, ValueError) as error:
        raise FormatError(
            "{path} is an archive without a {member} that can be read; unpack it and name that",
            path=path,
            member=member,
        ) from error


def _is_ended(head: bytes, tail: bytes) -> bool:
    """Whether the last bytes hold the end of the element that the first ones begin with.

    Zero bytes, as wider letters have, and comments count for nothing.
    """
    head, tail = head.replace(b"\0", b""), tail.replace(b"\0", b"")
    at = head.find(b"<")
    while (what := head[at : at + 2]) in (b"<!", b"<?"):
        end = head.find(b"-->" if what == b"<!" else b"?>", at)
        at = head.find(b"<", end) if end >= 0 else -1
    root = _NAME.match(head, at + 1) if at >= 0 else None
    if root is None:
        return tail.rstrip().endswith(b">")
    last = tail[tail.rfind(b"</" + root[0]) :]
    return last.startswith(b"</") and b">" in last and b"<" not in last[1:].replace(b"<!--", b"")


class _Text(ContentHandler):
    """The text that stands in the innermost element."""

    def __init__(self) -> None:
        super().__init__()
        self._pieces: list[str] = []
        self._length = 0

    @property
    def is_too_long(self) -> bool:
        """Whether more stands between two tags than anybody puts there, and be it spaces."""
        return self._length > _LONGEST

    def characters(self, content: str) -> None:
        """See the base."""
        self._length += len(content)
        if self._length <= _LONGEST:
            self._pieces.append(content)

    def taken(self) -> str | None:
        """The text since the last call; None where it was too long."""
        text = None if self.is_too_long else "".join(self._pieces)
        self._pieces.clear()
        self._length = 0
        return text


class _Parser(DefusedExpatParser):
    """Hands elements on as they come; what they hold is gone when they end."""

    _parser: XMLParserType

    def __init__(self, path: Path, elements: Elements) -> None:
        super().__init__(forbid_dtd=True)
        self._path, self._elements = path, elements
        self._text = _Text()
        self._depth = 0
        self.setContentHandler(self._text)

    def start_element(self, name: str, attrs: Mapping[str, str]) -> None:
        """See the base."""
        self._depth += 1
        if self._depth > _DEEPEST:
            raise self._refused(msg("elements are nested deeper than any of these files'"))
        self._text.taken()
        self._elements.start(name, attrs, self._parser.CurrentLineNumber)

    def end_element(self, name: str) -> None:
        """See the base."""
        self._depth -= 1
        self._elements.end(name, self._take_text())

    def check_waiting(self, read: int) -> None:
        """Refuse what is longer than any, before all of it is in memory or read."""
        if self._text.is_too_long:
            self._take_text()
        if read - self._parser.CurrentByteIndex > _LONGEST_ELEMENT + _PIECE:
            raise self._refused(msg("an element has more attributes than any of these files'"))

    def _take_text(self) -> str:
        text = self._text.taken()
        if text is None:
            raise self._refused(msg("an element has more text than any of these files'"))
        return text

    def _refused(self, reason: str) -> FormatError:
        line = self._parser.CurrentLineNumber
        return FormatError(
            "{path}, line {line}: {reason}; export it again",
            path=self._path,
            line=line,
            reason=reason,
        )
