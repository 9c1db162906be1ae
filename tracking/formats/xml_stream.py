"""XML from elsewhere, an element at a time, without anything a bomb needs.

No document type, no entities, nothing outside the file; elements nest a few deep, and one element's
text and attributes are short. Nothing of the file is kept but what the caller keeps.
"""

from __future__ import annotations

import zipfile
import zlib
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from pathlib import Path
from typing import IO, Protocol
from xml.sax import SAXException, SAXParseException
from xml.sax.handler import ContentHandler
from xml.sax.xmlreader import AttributesImpl

from defusedxml import DefusedXmlException
from defusedxml.sax import make_parser

from tracking.errors import FormatError

MOST_BYTES = 4 << 30
_PIECE = 1 << 18
_DEEPEST = 32
_MOST_ATTRIBUTES = 64
_LONGEST = 1 << 16
"""Characters of one element's text, and of its attributes together."""
ZIP = b"PK\x03\x04"


class Elements(Protocol):
    """Takes elements as they come."""

    def start(self, name: str, attributes: Mapping[str, str], line: int) -> None:
        """An element begins, on that line of the file."""

    def end(self, name: str, text: str) -> None:
        """An element ends; text: what stood in it directly."""


def parse(path: Path, elements: Elements, member: str) -> None:
    """Go through a file once.

    Args:
        path: of the XML, or of a ZIP archive that holds it.
        member: its name there.

    Raises FormatError where the file is missing, too large, no XML, or holds what is not taken;
    what `elements` raises is passed on.
    """
    parser = make_parser()
    parser.forbid_dtd = True
    parser.setContentHandler(_Handler(path, elements, lambda: int(parser.getLineNumber() or 0)))
    try:
        with _opened(path, member) as stream:
            read = 0
            while piece := stream.read(_PIECE):
                read += len(piece)
                if read > MOST_BYTES:
                    raise FormatError(
                        f"{path} is larger than {MOST_BYTES >> 30} GB; split it first"
                    )
                parser.feed(piece)
            if not read:
                raise FormatError(f"{path} is empty; export it again")
            parser.close()
    except DefusedXmlException as error:
        raise FormatError(f"{path} declares a document type or entities; remove them") from error
    except SAXParseException as error:
        reason = f"{path}, line {error.getLineNumber()}: no XML ({error.getMessage()})"
        raise FormatError(f"{reason}; export it again") from error
    except (SAXException, UnicodeError, LookupError) as error:
        raise FormatError(f"{path} is no XML that can be read; export it again") from error
    except (zipfile.BadZipFile, zlib.error, EOFError) as error:
        raise FormatError(f"{path} is an archive that is damaged; export it again") from error
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error


def _opened(path: Path, member: str) -> AbstractContextManager[IO[bytes]]:
    with path.open("rb") as stream:
        if stream.read(len(ZIP)) != ZIP:
            return path.open("rb")
    try:
        return zipfile.ZipFile(path).open(member)
    except (KeyError, zipfile.BadZipFile, NotImplementedError, RuntimeError, ValueError) as error:
        raise FormatError(
            f"{path} is an archive without a {member} that can be read; unpack it and name that"
        ) from error


class _Handler(ContentHandler):
    def __init__(self, path: Path, elements: Elements, line: Callable[[], int]) -> None:
        super().__init__()
        self._path, self._elements, self._line = path, elements, line
        self._texts: list[list[str]] = []
        self._length = 0

    def startElement(self, name: str, attrs: AttributesImpl[str]) -> None:  # noqa: N802
        """See the base."""
        if len(self._texts) >= _DEEPEST:
            raise self._refused("elements are nested deeper than any of these files'")
        self._texts.append([])
        self._length = 0
        attributes = dict(attrs.items())
        size = sum(map(len, attributes.values()))
        if len(attributes) > _MOST_ATTRIBUTES or size > _LONGEST or len(name) > _LONGEST:
            raise self._refused("an element has more attributes than any of these files'")
        self._elements.start(name, attributes, self._line())

    def characters(self, content: str) -> None:
        """See the base."""
        if not self._texts:
            return
        self._length += len(content)
        if self._length > _LONGEST:
            raise self._refused("an element has more text than any of these files'")
        self._texts[-1].append(content)

    def endElement(self, name: str) -> None:  # noqa: N802
        """See the base."""
        self._length = 0
        self._elements.end(name, "".join(self._texts.pop()).strip())

    def _refused(self, reason: str) -> FormatError:
        return FormatError(f"{self._path}, line {self._line()}: {reason}; export it again")
