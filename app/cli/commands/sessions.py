"""Commands for what people made: sessions to other tools and back, their log, backups."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import completions, import_options, options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import Bare, expand_groups
from tracking.translation import msg

ExportFormat = Annotated[
    str,
    typer.Option(
        "--format",
        autocompletion=completions.complete_export_formats,
        help="mot, mot16, kitti, csv, cvat, coco, pedpy-txt, pedpy-h5 ...; a wrong name lists "
        "them all. Of body parts: labels (CSV), or samples (OUT ends in .csv, .h5, .libsvm); "
        "in samples part is 0 head, 1 torso, 2 hip-leg; label is 1 on its part, 0 off it.",
    ),
]
AsGroundTruth = Annotated[
    bool,
    typer.Option(
        "--ground-truth",
        help="mot, mot16, kitti: write whether a row counts in place of the confidence. Files"
        " named gt/gt.txt or truth.txt, or in label_02/, get this without the option.",
    ),
]


@program.command(cls=HelpCommand)
def export(
    session: Annotated[Path, typer.Argument(help="A session.")],
    out: Annotated[
        Path, typer.Option("--out", "-o", help="The file to make; - is stdout, for text.")
    ],
    file_format: ExportFormat,
    run: Annotated[
        int | None,
        typer.Option(
            min=0,
            help="Number of a tracker's run, counted from 0.",
            show_default="the corrected tracks",
        ),
    ] = None,
    ground_truth: AsGroundTruth = False,
    force: Annotated[
        bool,
        typer.Option(
            "--force",
            help="Replace a text file that export did not write, without a question.",
        ),
    ] = False,
    json: options.Json = False,
) -> None:
    """Export a session's tracks for other tools; a note names what the format cannot hold."""
    from app.cli.export import ExportRequest, run_export

    request = ExportRequest(session, out, file_format, run, ground_truth, force)
    run_export(request, as_json=json)


@program.command("import", cls=HelpCommand)
@expand_groups
def import_tracks(
    tracks: import_options.Tracks,
    recording: import_options.Footage = None,
    out: import_options.Out = None,
    into: import_options.Into = None,
    file_format: import_options.FileFormat = None,
    *,
    unit: options.Unit = None,
    take_good: import_options.TakeGood = False,
    thin: import_options.Thin = None,
    as_new: import_options.AsNew = False,
    only_people: import_options.OnlyPeople = False,
    attributes: import_options.Attributes = None,
    report: import_options.Report = False,
    force: options.Force = False,
    bare: Bare,
    json: options.Json = False,
) -> None:
    """Import tracks of other programs into a session, with a report of invalid rows."""
    from app.cli.import_tracks import Order, run_import

    order = Order(
        tracks=tracks,
        format=file_format,
        recording=recording,
        bare=bare,
        out=out,
        into=into,
        unit=unit,
        thin_px=thin,
        as_new=as_new,
        only_people=only_people,
        take_good=take_good,
        force=force,
        report=report,
        attributes=attributes,
    )
    run_import(order, as_json=json)


@program.command(cls=HelpCommand)
def attributes(
    session: Annotated[Path, typer.Argument(help="A session.")],
    take: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Take which attributes people have from attributes.toml, or from JSON of CVAT's "
            "label constructor: one edit. Values that people have stay.",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "-o",
            help="Write which attributes people have: .toml, or .json for CVAT's constructor.",
        ),
    ] = None,
    force: Annotated[
        bool, typer.Option("--force", help="Replace a file that is there, without a question.")
    ] = False,
    json: options.Json = False,
) -> None:
    """Print which attributes the people of a session have, and the values that do not suit them."""
    from app.cli.attributes import run_attributes

    run_attributes(session, take, out, force=force, as_json=json)


@program.command(cls=HelpCommand)
def import_labels(
    labels: Annotated[
        Path, typer.Argument(help="CSV with frame, track, part, on and, where known, a rectangle.")
    ],
    session: Annotated[Path, typer.Argument(help="The session to import them into.")],
    author: Annotated[
        str | None,
        typer.Option(help="Name of the person who labelled, where the table does not state it."),
    ] = None,
    json: options.Json = False,
) -> None:
    """Import labels of body parts into a session."""
    from app.cli.import_labels import run_import_labels

    run_import_labels(labels, session, author, as_json=json)


@program.command(cls=HelpCommand)
def log(
    session: Annotated[Path, typer.Argument(help="A session.")],
    csv: Annotated[
        Path | None, typer.Option(help="Write it to this file as CSV; - is stdout.")
    ] = None,
    json: options.Json = False,
) -> None:
    """Print the edits of a session, oldest first; with --json all their rows and labels."""
    from app.cli.log import run_log

    run_log(session, csv, as_json=json)


@program.command(cls=HelpCommand)
def restore(
    session: Annotated[Path, typer.Argument(help="A session.")],
    backup: Annotated[
        int,
        typer.Option(
            "--backup",
            "--generation",
            min=1,
            help="Number of the backup; 1 is the newest. --generation is the option's old name.",
        ),
    ] = 1,
    only_list: Annotated[bool, typer.Option("--list", help="Only list the backups.")] = False,
    accept_damage: Annotated[
        bool,
        typer.Option(
            "--accept-damage",
            help="Restore nothing: accept a damaged session as it is, so that commands no longer "
            "report the damage.",
        ),
    ] = False,
    json: options.Json = False,
) -> None:
    """Restore a backup of a session; the current state is kept as the newest backup."""
    from app.cli.restore import run_accept, run_restore

    if accept_damage and only_list:
        raise typer.BadParameter(msg("give it without --list"), param_hint="--accept-damage")
    if accept_damage:
        run_accept(session, as_json=json)
        return
    run_restore(session, backup, only_list=only_list, as_json=json)
