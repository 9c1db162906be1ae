"""Settings of subtraction stereo."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class StereoSettings:
    """How the images of the two cameras are matched and how far away people can be."""

    nearest_m: float = setting(
        0.8,
        "m",
        (0.1, 20.0),
        "Smallest distance from the cameras at which people are detected; lower: nearer people "
        "are detected, and matching takes more time",
        expert=True,
    )
    farthest_m: float = setting(
        25.0,
        "m",
        (2.0, 200.0),
        "Largest distance from the cameras at which people are detected; higher: far people are "
        "detected, with less certain positions",
    )
    max_height_m: float = setting(
        2.2,
        "m",
        (1.0, 3.0),
        "Points above this height above the floor are ignored; lower: less time, but the heads of"
        " tall people may be cut off",
        formerly=("tallest_m",),
        expert=True,
    )
    window_px: int = setting(
        9,
        "px",
        (5, 31),
        "Side of the square window in which both images are compared, odd; higher: less noise, "
        "but thin objects and edges blur",
        odd=True,
        expert=True,
    )
