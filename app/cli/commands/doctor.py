"""The command that says what is wrong."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand


@program.command(cls=HelpCommand)
def doctor(
    recording: Annotated[
        Path | None,
        typer.Argument(help="Recording or session to examine.", show_default="this installation"),
    ] = None,
    mend: Annotated[
        str | None,
        typer.Option(
            "--mend",
            "--fix",
            help="Code of a finding to put right in the recording's files.",
            show_default="none",
        ),
    ] = None,
    pictures: Annotated[
        Path | None,
        typer.Option(help="Folder for pictures that show each finding.", show_default="none"),
    ] = None,
    json: options.Json = False,
) -> None:
    """Say what is wrong: with a recording, a session, or with this installation."""
    from app.cli.doctor import run_doctor

    run_doctor(recording, mend, pictures, as_json=json)
