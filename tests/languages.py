"""Catalogues of languages: kept up to the template, compiled, searched for what is missing."""

from __future__ import annotations

import re
import string
from collections.abc import Iterable, Iterator, Mapping
from io import BytesIO
from pathlib import Path
from typing import Final

from babel.messages.catalog import Catalog, Message
from babel.messages.mofile import write_mo
from babel.messages.pofile import read_po, write_po

FOLDER: Final = Path(__file__).parents[1] / "resources" / "translations"
_NAME = "trackwright"
Texts = tuple[str, ...]
"""A text as it stands in the code, or one and many of a count; its translations, in order."""


class Language(Catalog):
    """A catalogue whose header has no dates and no versions of tools: it changes with its texts."""

    @property  # type: ignore[override]
    def mime_headers(self) -> list[tuple[str, str]]:  # type: ignore[override]
        """What gettext reads of a catalogue."""
        return [
            ("Project-Id-Version", _NAME),
            ("Language", str(self.locale_identifier)),
            ("Plural-Forms", self.plural_forms),
            ("MIME-Version", "1.0"),
            ("Content-Type", "text/plain; charset=utf-8"),
            ("Content-Transfer-Encoding", "8bit"),
        ]


def languages() -> list[str]:
    """The languages that have a catalogue, e.g. "ja"."""
    return sorted(path.parents[1].name for path in FOLDER.glob(f"*/LC_MESSAGES/{_NAME}.po"))


def path_of(language: str, kind: str = "po") -> Path:
    """Where the catalogue of a language stands; kind: "po", or "mo" for the compiled one."""
    return FOLDER / language / "LC_MESSAGES" / f"{_NAME}.{kind}"


def read(path: Path) -> Catalog:
    """A catalogue, or a few texts in the same form."""
    with path.open("rb") as stream:
        return read_po(stream)


def texts_of(message: Message) -> Texts:
    """The text in the code that a message is of."""
    return message.id if isinstance(message.id, tuple) else (message.id,)


def translations(catalogue: Catalog) -> dict[Texts, Texts]:
    """What is translated: texts that are empty or a guess are not."""
    found = {}
    for message in messages(catalogue):
        said = message.string if isinstance(message.string, tuple) else (message.string,)
        if all(said) and not message.fuzzy:
            found[texts_of(message)] = tuple(map(str, said))
    return found


def messages(catalogue: Catalog) -> Iterator[Message]:
    """All messages but the header."""
    return (message for message in catalogue if message.id)


def joined(language: str, template: Catalog, *known: Mapping[Texts, Texts]) -> Language:
    """The texts of the template with their translations, and no others; the last known ones hold.

    No translation is guessed from a similar text: a text that has changed is missing.
    """
    said = {texts: said for each in known for texts, said in each.items()}
    catalogue = Language(locale=language, charset="utf-8", fuzzy=False)
    catalogue.header_comment = f"# {catalogue.locale.english_name} texts of {_NAME}; make messages"
    for message in messages(template):
        texts = texts_of(message)
        found = said.get(texts, ())
        several = len(texts) > 1
        catalogue.add(message.id, found if several else "".join(found), flags=message.flags)
    return catalogue


def po_of(catalogue: Catalog) -> bytes:
    """The catalogue as it is kept: sorted by text, a line each, so that changes are readable."""
    stream = BytesIO()
    write_po(stream, catalogue, width=0, no_location=True, sort_output=True, ignore_obsolete=True)
    return stream.getvalue()


def mo_of(catalogue: Catalog) -> bytes:
    """The catalogue as the program reads it: what is not translated it shows in English."""
    done = translations(catalogue)
    whole = Language(locale=catalogue.locale, charset="utf-8", fuzzy=False)
    for texts, said in done.items():
        several = len(texts) > 1
        whole.add(texts if several else texts[0], said if several else said[0])
    stream = BytesIO()
    write_mo(stream, whole)
    return stream.getvalue()


def update_of(
    language: str, template: Catalog, added: Mapping[Texts, Texts] | None = None
) -> Language:
    """The catalogue of a language as it is kept, brought up to the template."""
    path = path_of(language)
    known = translations(read(path)) if path.is_file() else {}
    return joined(language, template, known, added or {})


def update(
    language: str, template: Catalog, added: Mapping[Texts, Texts] | None = None
) -> Language:
    """Keep the catalogue brought up to the template, and compile it."""
    catalogue = update_of(language, template, added)
    path = path_of(language)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(po_of(catalogue))
    path_of(language, "mo").write_bytes(mo_of(catalogue))
    return catalogue


def missing(catalogue: Catalog) -> Catalog:
    """What is not translated, in a form that can be filled in and added."""
    done = translations(catalogue)
    rest = Language(locale=catalogue.locale, charset="utf-8", fuzzy=False)
    rest.header_comment = "# write the msgstr lines, then: python -m tests.catalogue --add FILE"
    for message in messages(catalogue):
        if texts_of(message) not in done:
            rest.add(message.id, flags=message.flags)
    return rest


def faults(catalogue: Catalog) -> Iterator[str]:
    """Translations whose places are not those of their text: they could not be filled."""
    for texts, said in translations(catalogue).items():
        for one in said:
            if places(one) != places(texts[-1]):
                yield f"{texts[-1]!r}: {places(texts[-1])} but {one!r}: {places(one)}"


def places(text: str) -> list[tuple[str, str, str]]:
    """The {named} places of a text, in the order of the alphabet, with how each is written."""
    if not re.search(r"\{\w", text):
        return []
    try:
        pieces = list(string.Formatter().parse(text))
    except ValueError:
        return [("braces", text, "")]
    return sorted((name, form or "", kind or "") for _, name, form, kind in pieces if name)


def without(texts: Iterable[Texts], catalogue: Catalog) -> list[Texts]:
    """Those that the catalogue has no message for."""
    held = {texts_of(message) for message in messages(catalogue)}
    return [each for each in texts if each not in held]
