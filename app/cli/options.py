"""Options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from tracking.errors import SettingsError

_BARE = "For input without recording.toml"
LARGEST_SEED = 2**63 - 1
"""What a session file can hold."""

Json = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout.")]
Force = Annotated[
    bool,
    typer.Option(
        "--force",
        help="Replace the file even if it is a session with corrections, or no session. A session"
        " without corrections is always replaced. The older session stays beside it as a "
        "backup.",
    ),
]


def _held_seed(seed: int) -> int:
    if not 0 <= seed <= LARGEST_SEED:
        raise SettingsError(
            "seed is {seed}; give --seed 0 to {largest}", seed=seed, largest=LARGEST_SEED
        )
    return seed


Seed = Annotated[int, typer.Option(callback=_held_seed, help="Seed of all random numbers.")]

_AGAIN = "Again, after corrections"
Again = Annotated[
    Path | None,
    typer.Option(
        "--again",
        help="A session: continue from its corrected tracks and print what would change.",
        rich_help_panel=_AGAIN,
    ),
]
From = Annotated[
    int | None,
    typer.Option("--from", min=0, help="The first frame to track again.", rich_help_panel=_AGAIN),
]
Until = Annotated[
    int | None,
    typer.Option(
        "--until", min=1, help="Stop before this frame.", show_default="all", rich_help_panel=_AGAIN
    ),
]
Accept = Annotated[
    bool,
    typer.Option(
        "--accept",
        help="Apply the changes and save. Rows that are corrected or reviewed stay as they are.",
        rich_help_panel=_AGAIN,
    ),
]

Left = Annotated[
    Path | None,
    typer.Option("--left", help="The left or only camera: a video.", rich_help_panel=_BARE),
]
Right = Annotated[
    Path | None, typer.Option("--right", help="The right camera: a video.", rich_help_panel=_BARE)
]
Calibration = Annotated[
    list[Path] | None,
    typer.Option(
        "--calibration", help="A calibration file; may be given twice.", rich_help_panel=_BARE
    ),
]
Height = Annotated[
    float | None,
    typer.Option(
        "--height", help="Height of the left camera above the floor, m.", rich_help_panel=_BARE
    ),
]
Tilt = Annotated[
    float | None,
    typer.Option(
        "--tilt",
        help="Angle of the camera's axis below the horizon, degrees.",
        rich_help_panel=_BARE,
    ),
]
Roll = Annotated[
    float | None,
    typer.Option(
        "--roll",
        help="Rotation of the camera about its axis, clockwise, degrees.",
        rich_help_panel=_BARE,
    ),
]
Fps = Annotated[
    float | None,
    typer.Option(
        "--fps",
        help="Frames per second, for images and for text files of tracks that do not state it.",
        rich_help_panel=_BARE,
    ),
]
Layout = Annotated[
    Literal["side-by-side", "top-bottom", "row-interleaved", "frame-sequential"] | None,
    typer.Option("--layout", help="How one video holds both cameras.", rich_help_panel=_BARE),
]
First = Annotated[
    Literal["left", "right"] | None,
    typer.Option(
        "--first", help="The camera that comes first in that video.", rich_help_panel=_BARE
    ),
]
LookRegion = Annotated[
    list[str] | None,
    typer.Option(
        "--region",
        help="Look for people within this outline of the left image only: x,y:x,y:x,y in pixels; "
        "may be repeated.",
        rich_help_panel=_BARE,
    ),
]
LookMask = Annotated[
    list[str] | None,
    typer.Option(
        "--mask",
        help="Look for nobody within this outline of the left image; may be repeated.",
        rich_help_panel=_BARE,
    ),
]
Outside = Annotated[
    bool,
    typer.Option(
        "--allow-outside",
        help="Allow files outside of the recording's folder.",
        rich_help_panel=_BARE,
    ),
]
Unit = Annotated[
    Literal["m", "cm"] | None,
    typer.Option("--unit", help="Unit of lengths, for text files of tracks that do not state it."),
]
