"""The command that calibrates cameras."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand

_BOARD, _ROUGH = "With a board", "Without a board"


@program.command(cls=HelpCommand)
def calibrate(
    left: Annotated[
        str, typer.Option(help="Images of the left camera: a video, a folder, or a pattern.")
    ],
    right: Annotated[
        str | None,
        typer.Option(help="The same of the right camera.", show_default="one camera"),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Calibration file to write.", show_default="none"),
    ] = None,
    board: Annotated[
        str,
        typer.Option(
            help="Size of the board: inner corners of a chessboard, squares of a ChArUco board, "
            "circles of a grid, as 9x6.",
            rich_help_panel=_BOARD,
        ),
    ] = "9x6",
    square: Annotated[
        float | None,
        typer.Option(
            help="Side of a square, or distance of two circles, m. Two cameras need it.",
            rich_help_panel=_BOARD,
        ),
    ] = None,
    kind: Annotated[
        Literal["chessboard", "charuco", "circles", "asymmetric-circles"],
        typer.Option(help="What is on the board.", rich_help_panel=_BOARD),
    ] = "chessboard",
    marker: Annotated[
        float | None,
        typer.Option(
            help="Side of a ChArUco marker, m.",
            show_default="three quarters of a square",
            rich_help_panel=_BOARD,
        ),
    ] = None,
    dictionary: Annotated[
        str,
        typer.Option(
            help="Dictionary of the ChArUco markers, as 5X5_100.",
            show_default="found",
            rich_help_panel=_BOARD,
        ),
    ] = "",
    lens: Annotated[
        Literal["standard", "fisheye"],
        typer.Option(help="Model of the lens.", rich_help_panel=_BOARD),
    ] = "standard",
    rough: Annotated[
        bool,
        typer.Option(
            "--rough",
            help="No board: find from matched points how the cameras stand. Metres are rough.",
            rich_help_panel=_ROUGH,
        ),
    ] = False,
    fov: Annotated[
        float | None,
        typer.Option(
            help="Horizontal field of view, degrees.",
            show_default="65, as of most cameras",
            rich_help_panel=_ROUGH,
        ),
    ] = None,
    baseline: Annotated[
        float | None,
        typer.Option(help="Distance of the two cameras, m.", rich_help_panel=_ROUGH),
    ] = None,
    json: options.Json = False,
) -> None:
    """Calibrate one camera or two, from images of a board or roughly from what they film."""
    from app.cli.calibrate import board_of, run_calibrate, run_rough

    if rough:
        run_rough(left, right, fov, baseline, output, as_json=json)
        return
    asked = board_of(board, kind, square, marker, dictionary)
    run_calibrate(left, right, asked, lens, output, as_json=json)
