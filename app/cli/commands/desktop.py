"""The command that enters the program into the desktop's menu."""

from __future__ import annotations

from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand


@program.command(cls=HelpCommand)
def desktop(
    remove: Annotated[bool, typer.Option("--remove", help="Take it out again.")] = False,
    json: options.Json = False,
) -> None:
    """Enter trackwright into the desktop's menu, so that a double click opens sessions (Linux)."""
    from app.cli.desktop import run_desktop

    run_desktop(remove=remove, as_json=json)
