"""`--language`: the language of what a command says, before the first of it is said."""

from __future__ import annotations

from collections.abc import Sequence

from tracking.errors import SettingsError
from tracking.translation import ask_language, joined, languages

OPTION = "--language"
_REST = "--"
"""What follows it are names of files, whatever they look like."""


def obeyed_language(words: Sequence[str]) -> list[str]:
    """The words without the option, wherever it stands among them, once its language is in use.

    Raises SettingsError where it names none, or one that there is no catalogue of.
    """
    end = words.index(_REST) if _REST in words else len(words)
    left, at = list[str](), 0
    while at < end:
        name, equals, value = words[at].partition("=")
        if name != OPTION:
            left.append(words[at])
        else:
            if not equals:
                at += 1
                value = words[at] if at < end else ""
            _use(value)
        at += 1
    return [*left, *words[end:]]


def _use(language: str) -> None:
    if not language:
        raise SettingsError(
            "--language names no language; choose one of: {known}",
            known=joined(", ", languages()),
        )
    if not ask_language(language):
        raise SettingsError(
            "--language {language}: there are no texts in it; choose one of: {known}",
            language=language,
            known=joined(", ", languages()),
        )
