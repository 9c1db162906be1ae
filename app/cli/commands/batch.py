"""The command for many recordings."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import Cost, EachRecording, Sharing, TrackerChoice, expand_groups


@program.command(cls=HelpCommand)
@expand_groups
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
    choice: TrackerChoice,
    each: EachRecording,
    sharing: Sharing,
    cost: Cost,
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

    words = tuple(recordings or ())
    request = BatchRequest(
        *(words, out, listed, choice, each, sharing, cost, retry, force, allow_outside)
    )
    run_batch(request, as_json=json)
