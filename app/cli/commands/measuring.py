"""Commands that measure results, and the program itself."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from app.cli import options
from app.cli.commands.program import program


@program.command()
def score(
    results: Annotated[
        list[Path],
        typer.Argument(
            metavar="RESULT",
            help="Sessions or files of tracks; or folders with one for each recording.",
        ),
    ],
    truth: Annotated[
        Path,
        typer.Option(
            "--truth",
            help="A session, a file of tracks or a recording with truth.txt; or a folder of them.",
        ),
    ],
    match: Annotated[
        Literal["box", "floor"], typer.Option(help="Pair by overlap or by floor distance.")
    ] = "box",
    radius: Annotated[
        float | None,
        typer.Option(
            help="Greatest distance on the floor, m; with --match floor.", show_default="0.5"
        ),
    ] = None,
    conventions: Annotated[
        Literal["trackeval", "py-motmetrics"],
        typer.Option("--as", help="Whose definitions hold where the field's programs differ."),
    ] = "trackeval",
    frames: Annotated[
        str | None,
        typer.Option(help="A:B, from 0, B not included: measure these.", show_default="all"),
    ] = None,
    ranges: Annotated[
        list[str] | None,
        typer.Option("--range", help="A:B, measured by itself, too; may be repeated."),
    ] = None,
    distances: Annotated[
        str | None,
        typer.Option(
            metavar="0,M,...",
            help="Measures by distance from the camera on the floor, m: 0,5,10 are 0 to 5, 5 to 10"
            " and 10 and more.",
        ),
    ] = None,
    per_person: Annotated[
        bool, typer.Option("--per-person", help="A row for each person of the truth.")
    ] = False,
    line: Annotated[
        list[str] | None,
        typer.Option(
            help="NAME:x1,y1:x2,y2 on the floor, m: compare the passages over it.",
            show_default="drawn in the session",
        ),
    ] = None,
    picture_line: Annotated[
        list[str] | None, typer.Option(help="NAME:u1,v1:u2,v2: the same in the picture, px.")
    ] = None,
    report: Annotated[
        Path | None,
        typer.Option(help="A folder for a report: a page, and the same as Markdown and JSON."),
    ] = None,
    allow_outside: Annotated[
        bool,
        typer.Option(
            "--allow-outside",
            help="Take the report's pictures also from outside of a session's folder.",
        ),
    ] = False,
    json: options.Json = False,
) -> None:
    """Measure results against truth."""
    from app.cli.score import run_score
    from app.cli.score_measuring import Asked, radius_of
    from app.cli.score_passages import lines_named

    asked = Asked(
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
    )
    run_score(asked, as_json=json)


@program.command()
def compare(
    a: Annotated[Path, typer.Argument(help="A session.")],
    b: Annotated[Path, typer.Argument(help="Another person's session of the same recording.")],
    match: Annotated[
        Literal["either", "box", "floor"],
        typer.Option(help="Pair by overlap, by floor distance, or by whichever fits better."),
    ] = "either",
    radius: Annotated[float, typer.Option(help="Greatest distance on the floor, m.")] = 0.5,
    json: options.Json = False,
) -> None:
    """Say how far two people's sessions agree on who is who."""
    from app.cli.compare import run_compare

    run_compare(a, b, match, radius, as_json=json)


@program.command()
def review(
    session: Annotated[Path, typer.Argument(help="A session.")],
    order: Annotated[
        Literal["yield", "worth", "likelihood", "time"],
        typer.Option(
            help="Yield finds most for the time watched; worth is likelihood times what would be"
            " wrong."
        ),
    ] = "yield",
    most: Annotated[
        int | None, typer.Option(min=1, help="How many at most.", show_default="all")
    ] = None,
    json: options.Json = False,
) -> None:
    """List where a session's tracks are likely wrong, and why."""
    from app.cli.review import run_review

    run_review(session, order, most, as_json=json)


@program.command()
def bench(
    only: Annotated[str | None, typer.Option(help="One group of them.")] = None,
    json: options.Json = False,
) -> None:
    """Measure speed, as ratios against peers; from a checkout of the source."""
    from app.cli.bench import run_bench

    run_bench(only, as_json=json)
