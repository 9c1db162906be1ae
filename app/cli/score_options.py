"""Options of `score`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

Results = Annotated[
    list[Path],
    typer.Argument(
        metavar="RESULT",
        help="Sessions or files of tracks; or folders with one for each recording.",
    ),
]
Truth = Annotated[
    Path,
    typer.Option(
        "--truth",
        help="A session, a file of tracks or a recording with truth.txt; or a folder of them.",
    ),
]
Match = Annotated[
    Literal["box", "floor"], typer.Option(help="Pair by overlap or by floor distance.")
]
Radius = Annotated[
    float | None,
    typer.Option(help="Greatest distance on the floor, m; with --match floor.", show_default="0.5"),
]
Conventions = Annotated[
    Literal["trackeval", "py-motmetrics"],
    typer.Option("--as", help="Whose definitions hold where the field's programs differ."),
]
Frames = Annotated[
    str | None,
    typer.Option(help="A:B, from 0, B not included: measure these.", show_default="all"),
]
Ranges = Annotated[
    list[str] | None,
    typer.Option("--range", help="A:B, measured by itself, too; may be repeated."),
]
Distances = Annotated[
    str | None,
    typer.Option(
        metavar="0,M,...",
        help="Measures by distance from the camera on the floor, m: 0,5,10 are 0 to 5, 5 to 10"
        " and 10 and more.",
    ),
]
Fps = Annotated[
    float | None, typer.Option(help="Frames a second, for tracks as text that does not say it.")
]
PerPerson = Annotated[
    bool, typer.Option("--per-person", help="A row for each person of the truth.")
]
Lines = Annotated[
    list[str] | None,
    typer.Option(
        help="NAME:x1,y1:x2,y2 on the floor, m: compare the passages over it.",
        show_default="drawn in the session",
    ),
]
PictureLines = Annotated[
    list[str] | None, typer.Option(help="NAME:u1,v1:u2,v2: the same in the picture, px.")
]
Report = Annotated[
    Path | None,
    typer.Option(help="A folder for a report: a page, and the same as Markdown and JSON."),
]
Outside = Annotated[
    bool,
    typer.Option(
        "--allow-outside",
        help="Take the report's pictures also from outside of a session's folder.",
    ),
]
