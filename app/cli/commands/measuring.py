"""Commands that measure results, and the program itself."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from app.cli import options
from app.cli.commands.program import program


@program.command()
def score(
    result: Annotated[Path, typer.Argument(help="A session or MOT text.")],
    truth: Annotated[
        Path, typer.Option("--truth", help="A session, MOT text or a recording with truth.txt.")
    ],
    match: Annotated[
        Literal["box", "floor"], typer.Option(help="Pair by overlap or by floor distance.")
    ] = "box",
    radius: Annotated[
        float, typer.Option(help="Greatest distance on the floor, m; with --match floor.")
    ] = 0.5,
    frames: Annotated[
        str | None,
        typer.Option(help="A:B, from 0, B not included: measure these.", show_default="all"),
    ] = None,
    report: Annotated[Path | None, typer.Option(help="A folder for a report.")] = None,
    json: options.Json = False,
) -> None:
    """Measure a result against truth."""
    from app.cli.score import How, run_score

    run_score(result, truth, How(match, radius, frames), report, as_json=json)


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
