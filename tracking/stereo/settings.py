"""Settings of subtraction stereo."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class StereoSettings:
    """How the two eyes are matched and how far away people can be."""

    nearest_m: float = setting(0.8, "m", (0.1, 20.0), "nobody is nearer to the camera")
    farthest_m: float = setting(25.0, "m", (2.0, 200.0), "nobody is farther from the camera")
    tallest_m: float = setting(2.2, "m", (1.0, 3.0), "nothing searched for is higher")
    window_px: int = setting(9, "px", (5, 31), "side of the matching window, odd", odd=True)
