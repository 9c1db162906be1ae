"""Help as plain text: options by their groups, and each command with its whole sentence.

Rich would draw the same in boxes, but importing it takes half of the time that `--help` needs.
"""

from __future__ import annotations

from typing import Any

import typer
from typer.core import TyperCommand, TyperGroup

WIDTH = 100
"""Of a page at most, in characters."""
_LONGEST_HELP = 200
_ARGUMENTS, _OPTIONS = "Arguments", "Options"


def _write_parameters(command: Any, context: typer.Context, formatter: Any) -> None:
    groups: dict[str, list[tuple[str, str]]] = {}
    for parameter in command.get_params(context):
        record = parameter.get_help_record(context)
        if record is None:
            continue
        usual = _ARGUMENTS if parameter.param_type_name == "argument" else _OPTIONS
        name = getattr(parameter, "rich_help_panel", None) or usual
        groups.setdefault(name, []).append(record)
    first = [name for name in (_ARGUMENTS, _OPTIONS) if name in groups]
    for name in (*first, *(one for one in groups if one not in first)):
        with formatter.section(name):
            formatter.write_dl(groups[name])


class HelpCommand(TyperCommand):
    """A command whose options stand by their groups."""

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the arguments and the options."""
        _write_parameters(self, ctx, formatter)


class HelpGroup(TyperGroup):
    """The program, whose commands stand with the whole first sentence of their help."""

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write the options, then the commands."""
        _write_parameters(self, ctx, formatter)
        commands = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        with formatter.section("Commands"):
            formatter.write_dl(
                [
                    (name, one.get_short_help_str(_LONGEST_HELP))
                    for name, one in commands
                    if one is not None and not one.hidden
                ]
            )
