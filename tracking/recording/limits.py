"""What a rate and a camera's place may be, whether a manifest or an option tells them."""

from __future__ import annotations

from tracking.errors import CalibrationError, RecordingError
from tracking.geometry import Ground
from tracking.translation import Message, msg

LEAST_FPS, MOST_FPS = 0.001, 10_000
"""Frames a second; recordings of days in pictures minutes apart, and high-speed cameras."""
LEAST_HEIGHT_M, MOST_HEIGHT_M = 0.01, 1000
"""People filmed from higher up are smaller than a pixel."""


_LIKELY_CM_M = 100.0
"""A camera so high films people of a few pixels; one in centimetres is given like that."""


def height_doubt(ground: Ground) -> Message | None:
    """What is said of a height that was likely meant in centimetres; None: it is usual."""
    if ground.height_m <= _LIKELY_CM_M:
        return None
    return msg(
        "the camera is {height_m:g} m above the floor; if centimetres were meant, give "
        "{metres:g} m",
        height_m=ground.height_m,
        metres=ground.height_m / 100,
    )


def checked_fps(fps: float, where: str) -> float:
    """The rate itself.

    Args:
        fps: frames per second. where: who told it, for the message.

    Raises:
        RecordingError: no camera takes that many frames per second; NaN, too.
    """
    if not LEAST_FPS <= fps <= MOST_FPS:
        raise RecordingError(
            "{where} must be {least_fps} to {most_fps} frames per second",
            where=where,
            least_fps=LEAST_FPS,
            most_fps=MOST_FPS,
        )
    return fps


def checked_ground(height_m: float, tilt_deg: float, roll_deg: float) -> Ground:
    """The floor below a camera at that place; see `Ground`.

    Raises:
        CalibrationError: `Ground` refuses it, or no camera is so low or so high.
    """
    ground = Ground(height_m, tilt_deg, roll_deg)
    if not LEAST_HEIGHT_M <= height_m <= MOST_HEIGHT_M:
        raise CalibrationError(
            "ground: height is {height_m:g} m; give the camera's height above the floor in "
            "metres, {least_height_m} to {most_height_m}",
            height_m=height_m,
            least_height_m=LEAST_HEIGHT_M,
            most_height_m=MOST_HEIGHT_M,
        )
    return ground
