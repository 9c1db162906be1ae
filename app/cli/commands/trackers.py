"""Commands that track, and that teach trackers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import completions, options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import Bare, Onward, Order, expand_groups
from tracking.translation import msg


@program.command(cls=HelpCommand)
def trackers(
    name: Annotated[
        str | None,
        typer.Argument(
            help="Show only this tracker.",
            show_default="all",
            autocompletion=completions.complete_trackers,
        ),
    ] = None,
    expert: Annotated[
        bool, typer.Option("--expert", help="Show the expert settings, too.")
    ] = False,
    json: options.Json = False,
) -> None:
    """List the trackers and their settings; expert settings with --expert or --json."""
    from app.cli.trackers import run_trackers

    run_trackers(name, expert=expert, as_json=json)


@program.command(cls=HelpCommand)
@expand_groups
def track(
    recording: Annotated[
        Path | None, typer.Argument(help="A recording's folder, a video or an image folder.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="The session to make: NAME.h5.")
    ] = None,
    *,
    order: Order,
    onward: Onward,
    force: options.Force = False,
    bare: Bare,
    json: options.Json = False,
) -> None:
    """Track the people in a recording, or track a corrected session again from a frame on."""
    if out is not None and out.suffix.lower() != ".h5":  # before trackers are imported
        reason = msg("a session's name ends in .h5: give {name}.h5", name=out.stem or "NAME")
        raise typer.BadParameter(reason, param_hint="--out")
    from app.cli.track import run_track
    from app.cli.track_again import parse_request, run_track_again

    if (request := parse_request(onward, recording, out, bare)) is not None:
        run_track_again(request, order, force=force, as_json=json)
        return
    if out is None:
        raise typer.BadParameter(msg("name the session to make"), param_hint="--out")
    run_track(recording, bare, out, order, force=force, as_json=json)


@program.command(cls=HelpCommand)
def train(
    sources: Annotated[
        list[Path],
        typer.Argument(
            help="Sessions with labelled body parts, or samples exported from sessions (.csv, .h5)."
        ),
    ],
    out: Annotated[
        Path, typer.Option("--out", "-o", help="The part-failure detector to make: NAME.h5.")
    ],
    report: Annotated[
        Path | None, typer.Option(help="Folder for a report with curves and mistakes.")
    ] = None,
    false_alarms: Annotated[
        float,
        typer.Option(
            min=0.0,
            max=0.5,
            help="Highest false alarm rate: share of correct parts that are called failed.",
        ),
    ] = 0.02,
    from_truth: Annotated[
        bool,
        typer.Option(
            "--from-truth",
            help="Use the ground truth beside rendered recordings as labels instead.",
        ),
    ] = False,
    from_scratch: Annotated[
        bool,
        typer.Option(
            "--from-scratch",
            help="Keep nothing of the built-in detector; for labels of a hundred people or more.",
        ),
    ] = False,
    paper: Annotated[
        bool,
        typer.Option("--paper", help="Use the features of Zhao and Lee 2009 alone."),
    ] = False,
    allow_outside: options.Outside = False,
    seed: options.Seed = 0,
    json: options.Json = False,
) -> None:
    """Train the part-failure detector from labels."""
    from app.cli.train import TrainRequest, run_train

    request = TrainRequest(
        *(tuple(sources), out, report, false_alarms, seed),
        *(from_truth, allow_outside, from_scratch, paper),
    )
    run_train(request, as_json=json)
