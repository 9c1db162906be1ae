"""Opening what a command names as a recording."""

from __future__ import annotations

from pathlib import Path

import typer

from app.cli.destination import read_file_kind
from app.cli.option_groups import Bare
from app.cli.shape_options import outlines_from
from tracking.errors import CalibrationError, RecordingError, SessionError
from tracking.formats import begins_as_hdf5
from tracking.recording import OpenOptions, Recording, open_recording
from tracking.recording.limits import checked_fps, checked_ground
from tracking.setup.files import needs_setup
from tracking.translation import msg, tr


def open_with_options(path: Path | None, bare: Bare, instead: str = "") -> Recording:
    """The recording at a path, or of the cameras the options name.

    Args:
        instead: what else can be done with a session, after the place of its path.

    Raises:
        RecordingError, CalibrationError: it cannot be opened, or is a session or other HDF5.
        typer.BadParameter: no recording is named, or a right camera alone.
    """
    place = path or bare.left
    if place is None:
        raise typer.BadParameter(msg("name a recording, or its cameras with --left and --right"))
    if _is_hdf5(place):
        raise _refusal(place, instead)
    try:
        return open_recording(place, options_of(bare))
    except RecordingError as error:
        if bare.left is None and needs_setup(place):
            raise error.advising("make one: trackwright setup {place}", place=place) from error
        raise


def _refusal(place: Path, instead: str) -> RecordingError:
    """What is told of an HDF5 file in the place of a recording."""
    # Longer to import than a recording to open.
    from tracking.session.layout import FORMAT
    from tracking.session.session_reader import check_file

    if read_file_kind(place) != FORMAT:
        return RecordingError(
            "{place} is an HDF5 file, neither a recording nor a session",
            "name a recording",
            place=place,
        )
    try:
        check_file(place)
    except SessionError as error:  # damaged, or of a newer version
        return RecordingError(error.message)
    return RecordingError(
        "{place} is a session, not a recording",
        "name the recording it is of, or {instead} {place}"
        if instead
        else "name the recording it is of",
        place=place,
        instead=instead,
    )


def _is_hdf5(place: Path) -> bool:
    try:
        return place.is_file() and begins_as_hdf5(place)
    except OSError:  # opening it tells why not
        return False


def options_of(bare: Bare) -> OpenOptions:
    """The same for the library."""
    if bare.right is not None and bare.left is None:
        raise typer.BadParameter(msg("a right camera needs a left one"), param_hint="--right")
    _check_numbers(bare)
    return OpenOptions(
        left=bare.left,
        right=bare.right,
        calibration=tuple(bare.calibration or ()),
        height_m=bare.height,
        tilt_deg=bare.tilt,
        roll_deg=bare.roll,
        fps=bare.fps,
        layout=bare.layout,
        first=bare.first,
        look=outlines_from(bare.region or (), "--region"),
        mask=outlines_from(bare.mask or (), "--mask"),
        allow_outside=bare.allow_outside,
    )


def _check_numbers(bare: Bare) -> None:
    """Raises BadParameter for a rate or a place that no camera has."""
    try:
        if bare.fps is not None:
            checked_fps(bare.fps, "it")
    except RecordingError as error:
        raise typer.BadParameter(tr(error.message), param_hint="--fps") from error
    placed = {"height": bare.height, "tilt": bare.tilt, "roll": bare.roll}
    usual = {"height": 1.0, "tilt": 0.0, "roll": 0.0}
    for name, value in placed.items():
        if value is not None:
            try:
                checked_ground(*(usual | {name: value}).values())
            except CalibrationError as error:
                raise typer.BadParameter(tr(error.message), param_hint=f"--{name}") from error
