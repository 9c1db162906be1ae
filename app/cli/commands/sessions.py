"""Commands for what people made: sessions to other tools and back, their log, older states."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program


@program.command()
def export(
    session: Annotated[Path, typer.Argument(help="A session.")],
    out: Annotated[Path, typer.Option("--out", "-o", help="The file to make.")],
    file_format: Annotated[
        str,
        typer.Option(
            "--format",
            help="mot; of body parts: labels (CSV), or samples (OUT ends in .csv, .h5, .libsvm). "
            "In samples part is 0 head, 1 torso, 2 hip-leg; label is 1 on its part, 0 off it.",
        ),
    ],
    run: Annotated[
        int | None,
        typer.Option(min=0, help="A tracker's run, from 0.", show_default="the corrected tracks"),
    ] = None,
    json: options.Json = False,
) -> None:
    """Write a session's tracks for other tools."""
    from app.cli.export import run_export

    run_export(session, out, file_format, run, as_json=json)


@program.command()
def import_labels(
    labels: Annotated[
        Path, typer.Argument(help="CSV: frame, track, part, on, and where known a rectangle.")
    ],
    session: Annotated[Path, typer.Argument(help="The session to take them into.")],
    author: Annotated[
        str | None, typer.Option(help="Who gave them, where the table does not say.")
    ] = None,
    json: options.Json = False,
) -> None:
    """Take labels of body parts made elsewhere into a session."""
    from app.cli.import_labels import run_import_labels

    run_import_labels(labels, session, author, as_json=json)


@program.command()
def log(
    session: Annotated[Path, typer.Argument(help="A session.")],
    csv: Annotated[Path | None, typer.Option(help="Write it to this file as CSV.")] = None,
    json: options.Json = False,
) -> None:
    """Print what people did to a session, oldest first; with --json all rows and labels of it."""
    from app.cli.log import run_log

    run_log(session, csv, as_json=json)


@program.command()
def restore(
    session: Annotated[Path, typer.Argument(help="A session.")],
    generation: Annotated[
        int, typer.Option(min=1, help="Which older one: 1 is the one saved last before this.")
    ] = 1,
    only_list: Annotated[
        bool, typer.Option("--list", help="Only list the ones that are kept.")
    ] = False,
    json: options.Json = False,
) -> None:
    """Put an older generation in a session's place; what it is now is kept as the newest one."""
    from app.cli.restore import run_restore

    run_restore(session, generation, only_list=only_list, as_json=json)
