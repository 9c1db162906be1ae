"""Opening what a command names as a recording."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import typer

from tracking.recording import OpenOptions, Recording, open_recording
from tracking.recording.eyes import Layout, Side


@dataclass(frozen=True, slots=True)
class Bare:
    """What the options say about a recording without recording.toml; None where they are silent.

    Attributes:
        left, right: videos. calibration: one or two files.
        height_m, tilt_deg, roll_deg: where the floor is.
        fps: of images. layout, first: of a video that holds both eyes.
        allow_outside: follow paths out of the recording's folder.
    """

    left: Path | None
    right: Path | None
    calibration: list[Path] | None
    height_m: float | None
    tilt_deg: float | None
    roll_deg: float | None
    fps: float | None
    layout: Layout | None
    first: Side | None
    allow_outside: bool


def opened(path: Path | None, bare: Bare) -> Recording:
    """The recording at a path, or of the eyes the options name.

    Raises:
        RecordingError, CalibrationError: it cannot be opened.
        typer.BadParameter: no recording is named, or a right eye alone.
    """
    place = path or bare.left
    if place is None:
        raise typer.BadParameter("name a recording, or its eyes with --left and --right")
    return open_recording(place, options_of(bare))


def options_of(bare: Bare) -> OpenOptions:
    """The same for the library."""
    if bare.right is not None and bare.left is None:
        raise typer.BadParameter("a right eye needs a left one", param_hint="--right")
    return OpenOptions(
        left=bare.left,
        right=bare.right,
        calibration=tuple(bare.calibration or ()),
        height_m=bare.height_m,
        tilt_deg=bare.tilt_deg,
        roll_deg=bare.roll_deg,
        fps=bare.fps,
        layout=bare.layout,
        first=bare.first,
        allow_outside=bare.allow_outside,
    )
