"""Typer's own words in the user's language: it has English sentences only, as finished texts.

Its words are looked up in the same catalogue as ours: whatever sentence of its is listed here is
told apart by its wording, as it has no other mark; one that is not listed is shown as it is.
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

import typer.core

from tracking.translation import N_, Message, msg, tr

_EXTRA: Final = N_("Got unexpected extra argument(s) ({words})")
SENTENCES: Final = (
    N_("Invalid value for {option}: {reason}"),
    N_("Invalid value: {reason}"),
    N_("Missing argument {name}"),
    N_("Missing option {name}"),
    N_("Missing command"),
    N_("No such option: {option} (Possible options: {others})"),
    N_("No such option: {option}"),
    N_("No such command {name}. Did you mean {others}?"),
    N_("No such command {name}"),
    N_("Option {option} requires an argument"),
    N_("Option {option} requires {n} arguments"),
    N_("Option {option} does not take a value"),
    _EXTRA,
    N_("Argument {name} takes {n} values"),
    N_("Value {text} is not a valid {kind}"),
    N_("Input should be a valid number, unable to parse string as a number"),
    N_("Input should be a valid integer, unable to parse string as an integer"),
    N_("Input should be a finite number"),
    N_("Input should be greater than or equal to {least}"),
    N_("Input should be less than or equal to {most}"),
)
"""Of wrong arguments, without the full stop; the first that fits holds."""
IN_HELP: Final = (N_("default: {default}"), N_("required"), N_("(dynamic)"), N_("env var: {var}"))
"""What stands beside an option."""
PLACEHOLDERS: Final = (N_("[OPTIONS]"), N_("COMMAND [ARGS]..."))
"""Of a usage line."""


def bind_words_of_help() -> None:
    """Have what typer writes beside options looked up in our catalogue instead of its own.

    Its sentences about wrong arguments stay English, so that `told_of` recognises them.
    """
    typer.core._ = lambda text: tr(text) if text in IN_HELP else text  # type: ignore[assignment, attr-defined]


def usage_pieces(pieces: list[str]) -> str:
    """The arguments of a usage line."""
    return " ".join(tr(piece) if piece in PLACEHOLDERS else piece for piece in pieces)


def told_of(misuse: Any, words: Sequence[str] = ()) -> Message:
    """What was wrongly asked for, in a line that says where more is told.

    Args:
        misuse: typer's UsageError; one raised by us has a message.
        words: what was typed; two cameras in the place of a recording are told how they become one.
    """
    asked = misuse.ctx.command_path if misuse.ctx is not None else "trackwright"
    own = misuse.message if isinstance(misuse.message, Message) else None
    what = _sentence(_on_one_line(misuse.format_message()), own)
    if what.template == _EXTRA and (cameras := _cameras_in(words)):
        return msg(
            "{left} and {right} are no recording yet; make one of them first: trackwright setup "
            "{left} {right}",
            left=shlex.quote(cameras[0]),
            right=shlex.quote(cameras[1]),
        )
    return msg("{what}; see {command} --help", what=what, command=asked)


def _sentence(text: str, own: Message | None = None) -> Message:
    """A sentence of typer's as a message; own: a reason of ours in it."""
    if own is not None and text == _on_one_line(own):
        return own
    for template in SENTENCES:
        if found := _PATTERNS[template].fullmatch(text):
            values: dict[str, object] = dict(found.groupdict())
            if "reason" in values:
                values["reason"] = _sentence(str(values["reason"]), own)
            return Message(template, **values)
    return Message("{text}", text=text)


def _cameras_in(words: Sequence[str]) -> Sequence[str]:
    """The two videos, or folders of images, among the words; none where there are not two."""
    # Takes longer to import than most commands' help to be shown.
    from tracking.setup.files import may_be_camera

    found = [word for word in words[1:] if may_be_camera(Path(word))]
    return found if len(found) == 2 else ()


def _on_one_line(text: str) -> str:
    return " ".join(text.split()).rstrip(".")


def _pattern(template: str) -> re.Pattern[str]:
    pieces = re.split(r"\{(\w+)\}", template)
    return re.compile(
        "".join(
            f"(?P<{piece}>.+?)" if at % 2 else re.escape(piece) for at, piece in enumerate(pieces)
        )
    )


_PATTERNS: Final = {template: _pattern(template) for template in SENTENCES}
