"""Settings of subtraction stereo."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class StereoSettings:
    """How the two eyes are matched and how far away people can be."""

    nearest_m: float = field(
        default=0.8,
        metadata={"unit": "m", "range": (0.1, 20.0), "help": "nobody is nearer to the camera"},
    )
    farthest_m: float = field(
        default=25.0,
        metadata={"unit": "m", "range": (2.0, 200.0), "help": "nobody is farther from the camera"},
    )
    tallest_m: float = field(
        default=2.2,
        metadata={"unit": "m", "range": (1.0, 3.0), "help": "nothing searched for is higher"},
    )
    window_px: int = field(
        default=9,
        metadata={"unit": "px", "range": (5, 31), "help": "side of the matching window, odd"},
    )
