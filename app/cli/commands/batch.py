"""The command for many recordings."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import completions, options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand

_WORK = "How the work is shared out"
_LIMITS = "What one recording may cost"


@program.command(cls=HelpCommand)
def batch(
    recordings: Annotated[
        list[str] | None,
        typer.Argument(
            help="Recordings, folders of recordings, patterns in quotes, or text files that list "
            "them."
        ),
    ] = None,
    *,
    out: Annotated[
        Path,
        typer.Option("--out", "-o", help="Folder for the sessions, the ledger and the report."),
    ],
    listed: Annotated[
        Path | None, typer.Option("--list", help="A file with a recording on each line.")
    ] = None,
    tracker: Annotated[
        str | None,
        typer.Option(
            help="Name of the tracker.",
            show_default="best for each recording",
            autocompletion=completions.complete_trackers,
        ),
    ] = None,
    setting: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            help="KEY=VALUE; trackwright trackers lists the settings.",
            autocompletion=completions.complete_settings,
        ),
    ] = None,
    seed: options.Seed = 0,
    detector: Annotated[
        Path | None, typer.Option(help="A part-failure detector made by train.")
    ] = None,
    detections: Annotated[
        str | None,
        typer.Option(
            help="Boxes of another program: a file in each recording's folder, or a path with "
            "{folder}, {name} or {stem}; * fits one file."
        ),
    ] = None,
    detections_right: Annotated[
        str | None, typer.Option(help="The same of the right camera.")
    ] = None,
    model: Annotated[
        Path | None,
        typer.Option(help="A network that finds people: the TOML beside an ONNX file."),
    ] = None,
    export: Annotated[
        list[str] | None,
        typer.Option(help="Write the tracks in this format, too; may be repeated."),
    ] = None,
    no_pages: Annotated[
        bool,
        typer.Option("--no-pages", help="Score, but write no page on each score."),
    ] = False,
    workers: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Processes on this machine, of one thread each.",
            show_default="one for each core",
            rich_help_panel=_WORK,
        ),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(
            help="Address of a Dask scheduler, such as tcp://host:8786.", rich_help_panel=_WORK
        ),
    ] = None,
    shard: Annotated[
        str | None,
        typer.Option(
            help="i/n: work on the i-th of n parts; others work on the other parts.",
            rich_help_panel=_WORK,
        ),
    ] = None,
    job_array: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Print a SLURM script that does this with so many shards, and do nothing else.",
            rich_help_panel=_WORK,
        ),
    ] = None,
    time_limit: Annotated[
        float | None,
        typer.Option(min=0, help="Longest time, s.", show_default="none", rich_help_panel=_LIMITS),
    ] = None,
    stall_limit: Annotated[
        float,
        typer.Option(
            min=0, help="Longest time without progress, s; 0: any.", rich_help_panel=_LIMITS
        ),
    ] = 1800.0,
    memory_limit: Annotated[
        int | None,
        typer.Option(
            min=0,
            help="Most memory, MB; 0: any.",
            show_default="an equal part of the machine's",
            rich_help_panel=_LIMITS,
        ),
    ] = None,
    retry: Annotated[
        bool,
        typer.Option("--retry", help="Try again also what failed and has not changed since."),
    ] = False,
    force: Annotated[
        bool,
        typer.Option(
            "--force", help="Track again also where somebody corrected the session; that is lost."
        ),
    ] = False,
    allow_outside: options.Outside = False,
    json: options.Json = False,
) -> None:
    """Track many recordings; run again, it does what is left or has changed."""
    from app.cli.batch import BatchRequest, run_batch
    from app.cli.option_groups import Order

    order = Order(tracker=tracker, setting=setting, seed=seed, detector=detector, model=model)
    request = BatchRequest(
        *(tuple(recordings or ()), out, order, listed),
        *(detections or "", detections_right or "", tuple(export or ()), not no_pages),
        *(workers, scheduler, shard, job_array),
        *(time_limit, stall_limit, memory_limit),
        *(retry, force, allow_outside),
    )
    run_batch(request, as_json=json)
