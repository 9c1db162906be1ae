"""Commands that measure results, and the program itself."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from app.cli import options, score_options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand


@program.command(cls=HelpCommand)
def score(
    results: score_options.Results,
    truth: score_options.Truth,
    match: score_options.Match = "box",
    radius: score_options.Radius = None,
    conventions: score_options.Conventions = "trackeval",
    frames: score_options.Frames = None,
    ranges: score_options.Ranges = None,
    distances: score_options.Distances = None,
    per_person: score_options.PerPerson = False,
    line: score_options.Lines = None,
    picture_line: score_options.PictureLines = None,
    report: score_options.Report = None,
    unit: options.Unit = None,
    fps: score_options.Fps = None,
    allow_outside: score_options.Outside = False,
    json: options.Json = False,
) -> None:
    """Score results against ground truth."""
    from app.cli.score import run_score
    from app.cli.score_measurement import MeasureRequest, radius_of
    from app.cli.score_passages import lines_named
    from tracking.formats import Stated

    asked = MeasureRequest(
        results=tuple(results),
        truth=truth,
        match=match,
        radius_m=radius_of(match, radius),
        conventions=conventions,
        frames=frames,
        ranges=tuple(ranges or ()),
        distances=distances,
        per_person=per_person,
        lines=lines_named(line or (), picture_line or ()),
        report=report,
        allow_outside=allow_outside,
        stated=Stated(unit or "", fps),
    )
    run_score(asked, as_json=json)


@program.command(cls=HelpCommand)
def compare(
    a: Annotated[Path, typer.Argument(help="A session.")],
    b: Annotated[Path, typer.Argument(help="Another person's session of the same recording.")],
    match: Annotated[
        Literal["either", "box", "floor"],
        typer.Option(
            help="Match rows by overlap of boxes, by distance on the floor, or by what fits better."
        ),
    ] = "either",
    radius: Annotated[float, typer.Option(help="Largest distance on the floor, m.")] = 0.5,
    json: options.Json = False,
) -> None:
    """Measure how well two sessions of a recording agree on who is who."""
    from app.cli.compare import run_compare

    run_compare(a, b, match, radius, as_json=json)


@program.command(cls=HelpCommand)
def review(
    session: Annotated[Path, typer.Argument(help="A session.")],
    order: Annotated[
        Literal["yield", "worth", "likelihood", "time"],
        typer.Option(
            help="yield: most errors found per time watched; likelihood: most likely errors "
            "first; worth, as in the window: likelihood times size of the error; time: by "
            "frame."
        ),
    ] = "yield",
    most: Annotated[
        int | None, typer.Option(min=1, help="Largest number of review items.", show_default="all")
    ] = None,
    hand_made: Annotated[
        bool,
        typer.Option(
            "--hand-made", help="Search also labels, imported ground truth and corrected ranges."
        ),
    ] = False,
    json: options.Json = False,
) -> None:
    """List where a session's tracks are likely wrong, and why."""
    from app.cli.review import run_review

    run_review(session, order, most, hand_made=hand_made, as_json=json)


@program.command(cls=HelpCommand)
def bench(
    only: Annotated[str | None, typer.Option(help="Measure only this group.")] = None,
    json: options.Json = False,
) -> None:
    """Measure speed as ratios to other programs; needs a checkout of the source."""
    from app.cli.bench import run_bench

    run_bench(only, as_json=json)
