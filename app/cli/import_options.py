"""Options of `import`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import completions

Tracks = Annotated[Path, typer.Argument(help="A file of tracks of another program.")]
Footage = Annotated[
    Path | None, typer.Option("--recording", "-r", help="The recording of these tracks.")
]
Out = Annotated[Path | None, typer.Option("--out", "-o", help="The session to make: NAME.h5.")]
Into = Annotated[
    Path | None,
    typer.Option(
        help="A session to import them into instead, as one edit: tracks of the file are added, "
        "or replace those with the same ids; all other tracks stay.",
    ),
]
FileFormat = Annotated[
    str | None,
    typer.Option(
        "--format",
        help="Format of the file.",
        show_default="told by content",
        autocompletion=completions.complete_import_formats,
    ),
]
TakeGood = Annotated[
    bool,
    typer.Option("--take-good", help="Import the valid rows even if others are invalid."),
]
Report = Annotated[
    bool, typer.Option("--report", help="List the rows that are invalid, and why, on stderr.")
]
Thin = Annotated[
    float | None,
    typer.Option(
        metavar="PX",
        help="Thin tracks with a keyframe in every frame; edges of boxes move by at most this "
        "many px.",
    ),
]
AsNew = Annotated[
    bool, typer.Option("--as-new", help="Give all tracks new ids, above the ids in use.")
]
Attributes = Annotated[
    Path | None,
    typer.Option(
        "--attributes",
        metavar="FILE",
        help="Which attributes people have: attributes.toml, or JSON of CVAT's label constructor.",
        show_default="of the project, else as the file says",
    ),
]
OnlyPeople = Annotated[
    bool, typer.Option("--only-people", help="Import only people, no other classes.")
]
