"""The command that counts people."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import InPicture, OnFloor, expand_groups


@program.command(cls=HelpCommand)
@expand_groups
def count(
    session: Annotated[Path, typer.Argument(help="A session.")],
    *,
    floor: OnFloor,
    step: Annotated[float, typer.Option(help="Length of a time step, s.")] = 0.5,
    csv: Annotated[
        Path | None, typer.Option(help="Write each step to this file; - is stdout.")
    ] = None,
    run: Annotated[
        int | None,
        typer.Option(
            min=0,
            help="Number of a tracker's run, counted from 0.",
            show_default="the corrected tracks",
        ),
    ] = None,
    picture: InPicture,
    json: options.Json = False,
) -> None:
    """Count people: passages over lines and people inside regions, in steps of time."""
    from app.cli.count import count_settings, places_named, run_count

    settings = count_settings(step, floor.jitter, picture.jitter_px)
    run_count(session, places_named(floor, picture), settings, run, csv, as_json=json)
