"""The command that calibrates cameras."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import BoardSquares, Roughly, expand_groups


@program.command(cls=HelpCommand)
@expand_groups
def calibrate(
    *,
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
    lens: Annotated[
        Literal["standard", "fisheye"], typer.Option(help="Model of the lens.")
    ] = "standard",
    board: Annotated[
        str,
        typer.Option(
            help="Size of the board: inner corners of a chessboard, squares of a ChArUco board, "
            "circles of a grid, as 9x6."
        ),
    ] = "9x6",
    squares: BoardSquares,
    roughly: Roughly,
    json: options.Json = False,
) -> None:
    """Calibrate one camera or two, from images of a board or roughly from what they film."""
    from app.cli.calibrate import board_of, run_calibrate, run_rough

    if roughly.rough:
        run_rough(left, right, roughly.fov, roughly.baseline, output, as_json=json)
        return
    run_calibrate(left, right, board_of(board, squares), lens, output, as_json=json)
