"""The command that lists plug-ins, and makes packages of them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand


@program.command(cls=HelpCommand)
def plugins(
    new: Annotated[
        str | None,
        typer.Argument(metavar="new", help="new: make a package.", show_default="list plug-ins"),
    ] = None,
    kind: Annotated[
        str | None,
        typer.Argument(
            metavar="KIND",
            help="tracker, format, recording or detector.",
            show_default="with new only",
        ),
    ] = None,
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="NAME",
            help="Its name: small letters and digits, with hyphens between.",
            show_default="with new only",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", help="Folder to make the package in.", show_default="here"),
    ] = None,
    json: options.Json = False,
) -> None:
    """List trackers, formats, recordings and detectors by where they come from; make new ones."""
    from app.cli.plugins import run_new, run_plugins, wanted_package

    if new is None:
        run_plugins(as_json=json)
    else:
        run_new(wanted_package(new, kind, name), out or Path(), as_json=json)
