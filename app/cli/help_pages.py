"""Help as plain text: options by their groups, and each command with its whole sentence.

Rich would draw the same in boxes, but importing it takes half of the time that `--help` needs.
"""

from __future__ import annotations

import re
from copy import copy
from inspect import cleandoc
from typing import Any

import typer
from typer.core import TyperCommand, TyperGroup

from app.cli.typer_texts import bind_words_of_help, usage_pieces
from tracking.text_columns import columns_of, lines_of
from tracking.translation import N_, tr

WIDTH = 100
"""Of a page at most, in characters."""
_NAMES, _BETWEEN = 30, 2
"""Columns for names of options and commands at most, and beside them."""
_LISTS = re.compile(r"<list\[(\w+)\]>")
bind_words_of_help()
_ARGUMENTS, _OPTIONS, _COMMANDS = N_("Arguments"), N_("Options"), N_("Commands")


def _write_parameters(command: Any, context: typer.Context, formatter: Any) -> None:
    groups: dict[str, list[tuple[str, str]]] = {}
    for parameter in map(_translated, command.get_params(context)):
        record = parameter.get_help_record(context)
        if record is None:
            continue
        usual = _ARGUMENTS if parameter.param_type_name == "argument" else _OPTIONS
        name = getattr(parameter, "rich_help_panel", None) or usual
        groups.setdefault(name, []).append((_LISTS.sub(_one_of, record[0]), record[1]))
    first = [name for name in (_ARGUMENTS, _OPTIONS) if name in groups]
    for name in (*first, *(one for one in groups if one not in first)):
        with formatter.section(tr(name)):
            _write_list(formatter, groups[name])


def _one_of(found: re.Match[str]) -> str:
    """What one of several values is, as it is written for a single one: "<path>..."."""
    return f"<{found[1].lower()}>..."


def _translated(parameter: Any) -> Any:
    """A copy of an argument or an option whose help is in the user's language."""
    shown = copy(parameter)
    shown.help = tr(parameter.help) if parameter.help else parameter.help
    if isinstance(parameter.show_default, str):
        shown.show_default = tr(parameter.show_default)
    return shown


def _summary(command: Any) -> str:
    """The first sentence of a command's help."""
    text = tr(clean_help(command.help or ""))
    return text.partition("\n\n")[0].replace("\n", " ").rstrip()


def clean_help(text: str) -> str:
    """Help without its indentation, as it is looked up in the catalogue."""
    return cleandoc(text)


def _write_text(command: Any, formatter: Any) -> None:
    formatter.write_paragraph()
    with formatter.indentation():
        width = formatter.width - formatter.current_indent
        formatter.write_text(_broken(tr(clean_help(command.help or "")), width))


def _write_list(formatter: Any, rows: list[tuple[str, str]]) -> None:
    """Write names and what they are: as the formatter does, but with wide letters counted."""
    first = min(max((len(name) for name, _ in rows), default=0), _NAMES) + _BETWEEN
    width = formatter.width - first - _BETWEEN
    formatter.write_dl([(name, _broken(told, width)) for name, told in rows], _NAMES, _BETWEEN)


def _broken(text: str, width: int) -> str:
    """A text with wide letters in lines that the formatter leaves as they are; others unchanged."""
    if columns_of(text) == len(text):
        return text
    paragraphs = (" ".join(each.split("\n")) for each in text.split("\n\n"))
    return "\n\n".join("\n".join(("\b", *lines_of(each, width))) for each in paragraphs)


def _write_usage(command: Any, context: Any, formatter: Any) -> None:
    pieces = usage_pieces(command.collect_usage_pieces(context))
    formatter.write_usage(context.command_path, pieces, prefix=tr("Usage:") + " ")


class HelpCommand(TyperCommand):
    """A command whose options stand by their groups."""

    def format_usage(self, ctx: Any, formatter: Any) -> None:
        """Write how the command is typed."""
        _write_usage(self, ctx, formatter)

    def format_help_text(self, ctx: Any, formatter: Any) -> None:  # noqa: ARG002 - typer's
        """Write what the command does."""
        _write_text(self, formatter)

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments and the options."""
        _write_parameters(self, ctx, formatter)


class HelpGroup(TyperGroup):
    """The program, whose commands stand with the whole first sentence of their help."""

    def format_usage(self, ctx: Any, formatter: Any) -> None:
        """Write how a command is typed."""
        _write_usage(self, ctx, formatter)

    def format_help_text(self, ctx: Any, formatter: Any) -> None:  # noqa: ARG002 - typer's
        """Write what the program is."""
        _write_text(self, formatter)

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the options, then the commands."""
        _write_parameters(self, ctx, formatter)
        commands = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        with formatter.section(tr(_COMMANDS)):
            shown = [(name, one) for name, one in commands if one is not None and not one.hidden]
            _write_list(formatter, [(name, _summary(one)) for name, one in shown])
