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
    Literal["box", "floor"],
    typer.Option(help="Match rows by overlap of boxes or by distance on the floor."),
]
Radius = Annotated[
    float | None,
    typer.Option(help="Largest distance on the floor, m; with --match floor.", show_default="0.5"),
]
Conventions = Annotated[
    Literal["trackeval", "py-motmetrics"],
    typer.Option("--as", help="Use the definitions of this program where scoring programs differ."),
]
Frames = Annotated[
    str | None,
    typer.Option(help="Score only frames A:B, counted from 0, without B.", show_default="all"),
]
Ranges = Annotated[
    list[str] | None,
    typer.Option("--range", help="Score frames A:B separately as well; may be repeated."),
]
Distances = Annotated[
    str | None,
    typer.Option(
        metavar="0,M,...",
        help="Score by distance from the camera on the floor, m: 0,5,10 means 0 to 5, 5 to 10, "
        "and 10 or more.",
    ),
]
Fps = Annotated[
    float | None,
    typer.Option(help="Frames per second, for text files of tracks that do not state it."),
]
PerPerson = Annotated[
    bool, typer.Option("--per-person", help="Print a row for each person of the ground truth.")
]
Lines = Annotated[
    list[str] | None,
    typer.Option(
        help="NAME:x1,y1:x2,y2 on the floor, m: compare the passages over this line.",
        show_default="drawn in the session",
    ),
]
PictureLines = Annotated[
    list[str] | None, typer.Option(help="NAME:u1,v1:u2,v2: the same for a line in the image, px.")
]
Report = Annotated[
    Path | None,
    typer.Option(help="Folder for a report as a web page, Markdown and JSON."),
]
Outside = Annotated[
    bool,
    typer.Option(
        "--allow-outside",
        help="Allow a recording outside of its session's folder for the report's pictures.",
    ),
]
