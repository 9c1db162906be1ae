"""`floor`: where the floor is, printed and written into recording.toml."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import typer

from app.cli.option_groups import Bare
from app.cli.output import print_json, print_table, progress, say
from app.cli.recordings import open_with_options
from tracking.calibration.boards import Board
from tracking.calibration.floor import (
    FloorEstimate,
    FloorPoint,
    floor_by_board,
    floor_by_people,
    floor_by_points,
    floor_by_pose,
    floor_by_stereo,
    with_calibration,
)
from tracking.errors import CalibrationError, RecordingError
from tracking.recording import MANIFEST_NAME, Recording
from tracking.recording.ground_writer import write_ground
from tracking.translation import msg, tr


@dataclass(frozen=True, slots=True)
class FloorRequest:
    """How the floor is to be found.

    Attributes:
        points: as typed, u,v:x,y. pose: a file; convention: words. heights: by people.
        board: that lies on the floor.
    """

    points: tuple[str, ...]
    pose: Path | None
    convention: str
    heights: bool
    board: Board | None = None


def run_floor(
    path: Path | None, bare: Bare, request: FloorRequest, *, write: bool, as_json: bool
) -> None:
    """Find the floor, print it, and write it where that is asked for."""
    ways = bool(request.points), request.pose is not None, request.heights
    if sum((*ways, request.board is not None)) > 1:
        raise typer.BadParameter(
            msg("give one of them"), param_hint="--points, --pose, --heights, --board"
        )
    clicked = tuple(map(_point, request.points))
    with open_with_options(path, bare) as recording:
        folder = _folder_to_write(recording) if write else None
        found = with_calibration(_found(recording, request, clicked), recording.calibration)
        if folder is not None:
            write_ground(folder, found.ground)
    for note in found.notes:
        say(note)
    if as_json:
        print_json(as_document(found))
    else:
        print_table(rows_of_floor(found))
        if folder is not None:
            say(msg("written: {path}", path=folder / MANIFEST_NAME))


def _point(text: str) -> FloorPoint:
    try:
        pixel, place = text.split(":")
        u, v = map(float, pixel.split(","))
        x, y = map(float, place.split(","))
    except ValueError as error:
        raise typer.BadParameter(
            msg("{text!r} is no point; write it as 320,240:1.5,4", text=text),
            param_hint="--points",
        ) from error
    return FloorPoint(u, v, x, y)


def _found(
    recording: Recording, request: FloorRequest, clicked: tuple[FloorPoint, ...]
) -> FloorEstimate:
    calibration = recording.calibration
    if request.pose is not None:
        camera = calibration.left if calibration is not None else None
        return floor_by_pose(request.pose, camera, request.convention)
    if clicked:
        if calibration is None:
            raise CalibrationError(
                "{path}: the floor by points needs a calibrated camera; give its calibration",
                option="--calibration",
                path=recording.path,
            )
        return floor_by_points(calibration.left, clicked)
    if request.board is not None:
        with progress(msg("looking for the board")) as tell:
            return floor_by_board(recording, request.board, tell)
    two = recording.is_stereo and calibration is not None and calibration.right is not None
    two = two or (recording.has_depth and calibration is not None)
    by_people = request.heights or not two
    with progress(msg("looking at people") if by_people else msg("looking at the floor")) as tell:
        find = floor_by_people if by_people else floor_by_stereo
        return find(recording, tell)


def _folder_to_write(recording: Recording) -> Path:
    """Where the recording.toml stands that the floor is written into."""
    if recording.manifest_folder is None:
        raise RecordingError(
            "{path}: has no recording.toml of its own to write the floor into; make one with "
            "trackwright setup, or leave --write out",
            path=recording.path,
        )
    return recording.manifest_folder


def as_document(found: FloorEstimate) -> dict[str, Any]:
    """As the contract names it."""
    ground = found.ground
    return {
        "height": ground.height_m,
        "tilt": ground.tilt_deg,
        "roll": ground.roll_deg,
        "method": found.method,
        "sigma": {
            "height": found.height_sigma_m,
            "tilt": found.tilt_sigma_deg,
            "roll": found.roll_sigma_deg,
        },
        "notes": [tr(note) for note in found.notes],
    }


def rows_of_floor(found: FloorEstimate) -> list[tuple[str, object]]:
    """Its figures with what they may be off by, in words."""
    ground = found.ground
    angle = "{angle:.2f} degrees, give or take {sigma:.2f}"
    return [
        (
            msg("height"),
            msg(
                "{height:.3f} m, give or take {sigma:.3f}",
                height=ground.height_m,
                sigma=found.height_sigma_m,
            ),
        ),
        (msg("tilt"), msg(angle, angle=ground.tilt_deg, sigma=found.tilt_sigma_deg)),
        (msg("roll"), msg(angle, angle=ground.roll_deg, sigma=found.roll_sigma_deg)),
        (msg("found by"), msg(found.method)),
    ]
