"""Options that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from tracking.errors import SettingsError

_BARE = "Without recording.toml"
LARGEST_SEED = 2**63 - 1
"""What a session file can hold."""

Json = Annotated[bool, typer.Option("--json", help="Print one JSON document on stdout.")]
Force = Annotated[
    bool,
    typer.Option(
        "--force",
        help="Replace also a file that is no session and a session with corrections; one without "
        "is replaced anyway. The older session stays beside it as a backup.",
    ),
]


def _held_seed(seed: int) -> int:
    if not 0 <= seed <= LARGEST_SEED:
        raise SettingsError(f"seed is {seed}; give --seed 0 to {LARGEST_SEED}")
    return seed


Seed = Annotated[int, typer.Option(callback=_held_seed, help="Of all random numbers.")]

_AGAIN = "Again, after corrections"
Again = Annotated[
    Path | None,
    typer.Option(
        "--again",
        help="A session: go on from its corrected tracks and print what would change there.",
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
        "--until", min=1, help="The first frame not to.", show_default="all", rich_help_panel=_AGAIN
    ),
]
Accept = Annotated[
    bool,
    typer.Option(
        "--accept",
        help="Take what changes, except what somebody corrected or marked as reviewed, and save.",
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
    typer.Option("--calibration", help="A calibration file; twice for two.", rich_help_panel=_BARE),
]
Height = Annotated[
    float | None,
    typer.Option("--height", help="Of the left camera over the floor, m.", rich_help_panel=_BARE),
]
Tilt = Annotated[
    float | None,
    typer.Option("--tilt", help="Of its axis below the horizon, degrees.", rich_help_panel=_BARE),
]
Roll = Annotated[
    float | None,
    typer.Option("--roll", help="About its axis, clockwise, degrees.", rich_help_panel=_BARE),
]
Fps = Annotated[
    float | None,
    typer.Option(
        "--fps",
        help="Frames a second, for images and for tracks as text without it.",
        rich_help_panel=_BARE,
    ),
]
Layout = Annotated[
    Literal["side-by-side", "top-bottom"] | None,
    typer.Option("--layout", help="How both cameras lie in one video.", rich_help_panel=_BARE),
]
First = Annotated[
    Literal["left", "right"] | None,
    typer.Option("--first", help="The camera that comes first there.", rich_help_panel=_BARE),
]
Outside = Annotated[
    bool,
    typer.Option(
        "--allow-outside",
        help="Follow paths out of the recording's folder.",
        rich_help_panel=_BARE,
    ),
]
Unit = Annotated[
    Literal["m", "cm"] | None,
    typer.Option("--unit", help="Of lengths in tracks as text that does not say it."),
]
