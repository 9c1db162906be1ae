"""The command that finds the floor."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from app.cli import options
from app.cli.commands.program import program
from app.cli.help_pages import HelpCommand
from app.cli.option_groups import Bare, BoardSquares, expand_groups


@program.command(cls=HelpCommand)
@expand_groups
def floor(
    recording: Annotated[Path | None, typer.Argument(help="A recording.")] = None,
    *,
    bare: Bare,
    points: Annotated[
        list[str] | None,
        typer.Option(
            help="A pixel of the left image and its place on the floor, u,v:x,y in px and m. Give "
            "four or more, not on a line.",
        ),
    ] = None,
    pose: Annotated[
        Path | None,
        typer.Option(help="File with the camera's pose: R and t, or a 4 x 4 matrix."),
    ] = None,
    convention: Annotated[
        str,
        typer.Option(
            help="How the pose is meant, in words: camera-from-world or world-from-camera, opencv "
            "or opengl, z, -z, y or -y (the axis that points up), m or mm.",
            show_default="the one by which the camera sees a floor",
        ),
    ] = "",
    heights: Annotated[
        bool, typer.Option("--heights", help="Find it by people's heights, with one camera.")
    ] = False,
    board: Annotated[
        str | None,
        typer.Option(
            help="Size of a board that lies on the floor: inner corners of a chessboard, squares "
            "of a ChArUco board, circles of a grid, as 9x6.",
            show_default="no board",
        ),
    ] = None,
    squares: BoardSquares,
    write: Annotated[bool, typer.Option("--write", help="Write it into recording.toml.")] = False,
    json: options.Json = False,
) -> None:
    """Find where the floor is: by stereo, clicked points, a board, a pose, or people."""
    from app.cli.calibrate import board_of
    from app.cli.floor import FloorRequest, run_floor

    lying = None if board is None else board_of(board, squares)
    request = FloorRequest(tuple(points or ()), pose, convention, heights, lying)
    run_floor(recording, bare, request, write=write, as_json=json)
