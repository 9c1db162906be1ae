"""Texts in the user's language: one mechanism for the window, the command line and the library.

English stands in the code and is what a catalogue is looked up by. Catalogues are gettext's, made
from the texts that `make messages` extracts. A `Message` is translated where it is shown; errors,
notes and the texts of edits are messages.
"""

from __future__ import annotations

import gettext
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import takewhile
from pathlib import Path
from typing import Final, Self

import resources

CATALOGUES: Final = Path(resources.__file__).parent / "translations"
"""LANGUAGE/LC_MESSAGES/trackwright.mo, and the texts to translate, trackwright.pot."""
ENGLISH: Final = "en"
FONT_PACKAGES: Final = {"ja": "fonts-noto-cjk"}
"""Debian's packages with letters that a plain installation may have no font for, by language."""
_DOMAIN = "trackwright"
_VARIABLES: Final = ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")
"""What names the language in the environment; the first that is set holds, as in gettext."""
_PLAIN: Final = frozenset({ENGLISH, "C", "POSIX"})
_catalogue: gettext.NullTranslations = gettext.NullTranslations()
_asked = ""


def languages() -> tuple[str, ...]:
    """The languages that texts can be shown in: English, and those that have a catalogue."""
    found = (path.parents[1].name for path in CATALOGUES.glob(f"*/LC_MESSAGES/{_DOMAIN}.mo"))
    return (ENGLISH, *sorted(found))


def use_language(language: str | None = None) -> None:
    """Show texts in a language, e.g. "ja".

    None: in the first one of LANGUAGE, LC_ALL, LC_MESSAGES and LANG that the environment names.
    Where there is no catalogue, texts stay English.
    """
    wanted = environment_languages() if language is None else [language]
    known = list(takewhile(lambda one: not _is_english(one), wanted))
    use_catalogue(gettext.translation(_DOMAIN, CATALOGUES, known, fallback=True))


def ask_language(language: str) -> bool:
    """Show texts in the language that the command line asks for, here and in programs begun here.

    Returns whether texts can be shown in it. It holds over what the window remembers; `asked` then.
    """
    global _asked
    if not (_is_english(language) or gettext.find(_DOMAIN, CATALOGUES, [language])):
        return False
    _asked = os.environ["LANGUAGE"] = language
    use_language(language)
    return True


def asked_language() -> str:
    """What the command line asked for; "": nothing."""
    return _asked


def forget_asked_language() -> None:
    """Somebody chose another language since."""
    global _asked
    _asked = ""


def environment_languages() -> list[str]:
    """What the environment names, e.g. ["ja_JP.UTF-8"], the best first; empty: nothing."""
    named = next(filter(None, (os.environ.get(one, "") for one in _VARIABLES)), "")
    return [one for one in named.split(":") if one]


def _is_english(language: str) -> bool:
    return language.replace("-", "_").partition("_")[0].partition(".")[0] in _PLAIN


def use_catalogue(catalogue: gettext.NullTranslations | None) -> None:
    """Look texts up in a catalogue; None: show them in English."""
    global _catalogue
    _catalogue = catalogue or gettext.NullTranslations()


def language_in_use() -> str:
    """The language of the catalogue in use, e.g. "pt_BR"; "" for English."""
    return _catalogue.info().get("language", "")


def language_environment() -> dict[str, str]:
    """What a program that is begun from here is told, so that it speaks the language in use."""
    return {"LANGUAGE": language_in_use() or ENGLISH}


class Message(str):
    """An English sentence that knows what it was made of, so that it can be shown in any language.

    It is the sentence wherever a text is wanted: it compares, is sorted and is kept as one. What
    makes another text of it (an f-string, `strip`) gives the English sentence only; `+` gives a
    message.

    Attributes:
        template: the sentence with {named} places. many: for several of `values["n"]`, or "".
        values: what fills the places: numbers, texts of users and files, messages.
    """

    __slots__ = ("_cut", "many", "template", "values")
    template: str
    many: str
    values: Mapping[str, object]
    _cut: Callable[[str], str] | None

    def __new__(cls, template: str = "", many: str = "", /, **values: object) -> Self:
        """A template that has no values is the sentence itself, whatever braces it has."""
        held = {name: _held(value) for name, value in values.items()}
        message = super().__new__(cls, _filled(many if many and held["n"] != 1 else template, held))
        message.template, message.many, message.values, message._cut = template, many, held, None
        return message

    def __add__(self, more: str) -> Message:
        """Both, one after the other."""
        return joined("", (self, more))

    def __radd__(self, before: str) -> Message:
        """The same after another text."""
        return joined("", (before, self))

    def translated(self, filled: Callable[[str, Mapping[str, object]], str] | None = None) -> str:
        """The sentence in the user's language; English where its translation cannot be filled.

        Args:
            filled: fills a template with values; None: `str.format` does.
        """
        fill = filled or _filled
        values = {name: shown(value) for name, value in self.values.items()}
        try:
            text = fill(self._looked_up(), values)
        except (LookupError, ValueError):
            text = fill(self.template, values)
        return self._cut(text) if self._cut else text

    def cut_by(self, cut: Callable[[str], str]) -> Message:
        """The sentence as `cut` leaves it, in every language."""
        message = str.__new__(Message, cut(self))
        message.template, message.many, message.values = self.template, self.many, self.values
        message._cut = cut
        return message

    def with_values(self, change: Callable[[object], object]) -> Message:
        """The same sentence with each value as `change` makes it, in nested messages, too."""
        values = {
            name: value.with_values(change) if isinstance(value, Message) else change(value)
            for name, value in self.values.items()
        }
        message = Message(self.template, self.many, **values)
        return message.cut_by(self._cut) if self._cut else message

    def _looked_up(self) -> str:
        if self.many:
            return _catalogue.ngettext(self.template, self.many, int(str(self.values["n"])))
        return _catalogue.gettext(self.template) if self.template else ""


def msg(template: str, /, **values: object) -> Message:
    """A message with its {named} places filled; a message that is given stays as it is."""
    return template if isinstance(template, Message) else Message(template, **values)


def count_msg(n: int, one: str, many: str, /, **values: object) -> Message:
    """How many of something, as a message: `one` or `many` of them, with {n} for the number."""
    return Message(one, many, n=n, **values)


def joined(separator: str, texts: Iterable[object]) -> Message:
    """Texts, numbers and messages one after the other, as a message.

    The separator is translated, too: not every language writes lists with ", ".
    """
    values = {f"v{at}": text for at, text in enumerate(texts)}
    if len(values) == 1 and isinstance(alone := values["v0"], Message):
        return alone
    template = ("{between}" if separator else "").join(f"{{{name}}}" for name in values)
    if separator and len(values) > 1:
        return Message(template, between=Message(separator), **values)
    return Message(template, **values)


def all_of(texts: Sequence[object]) -> Message:
    """Everything that is meant, as a message, e.g. "a, b and c"."""
    if len(texts) < 2:
        return joined(", ", texts)
    return msg("{first} and {last}", first=joined(", ", texts[:-1]), last=texts[-1])


def some_of(texts: Sequence[object], most: int) -> Message:
    """The first ones and how many more there are, as a message, e.g. "a, b and 3 more"."""
    first = joined(", ", texts[:most])
    more = len(texts) - most
    return msg("{first} and {n} more", first=first, n=more) if more > 0 else first


def tr(text: str, /, **values: object) -> str:
    """A text or a message in the user's language, with its {named} places filled."""
    return msg(text, **values).translated()


def message_of(error: BaseException) -> Message:
    """What an error says, as the message it was raised with; "" where it says nothing."""
    said = error.args[0] if len(error.args) == 1 else None
    return said if isinstance(said, Message) else Message("{error}", error=str(error))


def count_text(count: int, one: str, many: str, /, **values: object) -> str:
    """How many of something in the user's language: `count_msg`, translated."""
    return count_msg(count, one, many, **values).translated()


def joined_text(separator: str, texts: Iterable[object]) -> str:
    """Texts one after the other in the user's language: `joined`, translated."""
    return joined(separator, texts).translated()


def shown(value: object) -> object:
    """A message in the user's language; anything else, such as a name from a file, as it is."""
    return value.translated() if isinstance(value, Message) else value


def N_(text: str) -> str:  # noqa: N802 - gettext's name
    """Marks a text that is translated later, where it is shown."""
    return text


def _held(value: object) -> object:
    return message_of(value) if isinstance(value, BaseException) else value


def _filled(template: str, values: Mapping[str, object]) -> str:
    return template.format(**values) if values else template
