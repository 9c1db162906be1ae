"""What a rate and a camera's place may be, whether a manifest or an option tells them."""

from __future__ import annotations

from tracking.errors import CalibrationError, RecordingError
from tracking.geometry import Ground

MOST_FPS = 10_000
"""Frames a second; high-speed cameras stay below."""
MOST_HEIGHT_M = 1000
"""People filmed from higher up are smaller than a pixel."""


def checked_fps(fps: float, where: str) -> float:
    """The rate itself.

    Args:
        fps: frames a second. where: who told it, for the message.

    Raises:
        RecordingError: no camera takes that many frames a second; NaN, too.
    """
    if not 0 < fps <= MOST_FPS:
        raise RecordingError(f"{where} must be more than 0 and at most {MOST_FPS} frames a second")
    return fps


def checked_ground(height_m: float, tilt_deg: float, roll_deg: float) -> Ground:
    """The floor below a camera at that place; see `Ground`.

    Raises:
        CalibrationError: `Ground` refuses it, or no camera is so high.
    """
    ground = Ground(height_m, tilt_deg, roll_deg)
    if height_m > MOST_HEIGHT_M:
        raise CalibrationError(
            f"ground: height is {height_m:g} m; give the camera's height above the floor in "
            f"metres, at most {MOST_HEIGHT_M}"
        )
    return ground
