"""Options of `import`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import completions

Tracks = Annotated[Path, typer.Argument(help="A file of tracks made elsewhere.")]
Footage = Annotated[
    Path | None, typer.Option("--recording", "-r", help="The recording they are of.")
]
Out = Annotated[Path | None, typer.Option("--out", "-o", help="The session to make: NAME.h5.")]
Into = Annotated[
    Path | None,
    typer.Option(
        help="A session to take them into instead, as one edit: tracks of the file are added "
        "or take the place of those with their ids; no other track goes.",
    ),
]
FileFormat = Annotated[
    str | None,
    typer.Option(
        "--format",
        help="Of the file.",
        show_default="told by content",
        autocompletion=completions.complete_import_formats,
    ),
]
TakeGood = Annotated[
    bool,
    typer.Option("--take-good", help="Take the good rows also where others are bad."),
]
Report = Annotated[
    bool, typer.Option("--report", help="List the rows that are invalid, and why, on stderr.")
]
Thin = Annotated[
    float | None,
    typer.Option(
        metavar="PX",
        help="Thin tracks of which every row is a keyframe: no edge of a box ends up farther "
        "off than this many px.",
    ),
]
AsNew = Annotated[
    bool, typer.Option("--as-new", help="Give all tracks new ids, above those known.")
]
OnlyPeople = Annotated[
    bool, typer.Option("--only-people", help="Leave out what the file says is no person.")
]
