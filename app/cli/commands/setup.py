"""The command that sets a recording up."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import Bare, expand_groups


@program.command(cls=HelpCommand)
@expand_groups
def setup(
    sources: Annotated[
        list[Path] | None,
        typer.Argument(help="One or two videos or image folders, or a folder with them."),
    ] = None,
    *,
    bare: Bare,
    name: Annotated[
        str, typer.Option(help="Name of the recording.", show_default="the folder's")
    ] = "",
    lag: Annotated[
        int | None,
        typer.Option(help="Frames by which the right camera is late.", show_default="found"),
    ] = None,
    as_given: Annotated[
        bool,
        typer.Option("--as-given", help="Take the cameras as they are given; find nothing."),
    ] = False,
    find_floor: Annotated[
        Literal["stereo", "people"] | None,
        typer.Option("--floor", help="Find the floor.", show_default="as given"),
    ] = None,
    force: Annotated[
        bool, typer.Option("--force", help="Replace the recording.toml that is there.")
    ] = False,
    json: options.Json = False,
) -> None:
    """Make a recording.toml for videos or images: find the pair, which is left, and the lag."""
    from app.cli.setup import SetupRequest, run_setup

    request = SetupRequest(tuple(sources or ()), name, lag, as_given, find_floor, force)
    run_setup(request, bare, as_json=json)
