"""The command that counts people."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program

_PICTURE = "In the picture, where there is no calibration"


@program.command()
def count(
    session: Annotated[Path, typer.Argument(help="A session.")],
    line: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:x1,y1:x2,y2 on the floor, m; forward crosses from its left-hand side,"
            " looking from the first to the second point, to its right-hand side.",
            show_default="drawn in the session",
        ),
    ] = None,
    region: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:x,y:x,y:x,y... on the floor, m.", show_default="drawn in the session"
        ),
    ] = None,
    step: Annotated[float, typer.Option(help="How time is cut, s.")] = 0.5,
    csv: Annotated[Path | None, typer.Option(help="Write each step to this file.")] = None,
    run: Annotated[
        int | None,
        typer.Option(min=0, help="A tracker's run, from 0.", show_default="the corrected tracks"),
    ] = None,
    jitter: Annotated[
        float,
        typer.Option(help="Passing to and fro within this distance of a line is no passage, m."),
    ] = 0.0,
    picture_line: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:u1,v1:u2,v2 in px of the left eye; people pass with the foot of their box.",
            rich_help_panel=_PICTURE,
        ),
    ] = None,
    picture_region: Annotated[
        list[str] | None,
        typer.Option(help="NAME:u,v:u,v:u,v... in px.", rich_help_panel=_PICTURE),
    ] = None,
    jitter_px: Annotated[
        float, typer.Option(help="As --jitter, in px.", rich_help_panel=_PICTURE)
    ] = 0.0,
    json: options.Json = False,
) -> None:
    """Count people: passages over lines and people inside regions, in steps of time."""
    from app.cli.count import how_of, places_named, run_count

    named = places_named(line or [], region or [], picture_line or [], picture_region or [])
    run_count(session, named, how_of(step, jitter, jitter_px), run, csv, as_json=json)
