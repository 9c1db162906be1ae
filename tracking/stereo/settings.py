"""Settings of subtraction stereo."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class StereoSettings:
    """How the two eyes are matched and how far away people can be."""

    nearest_m: float = setting(
        0.8,
        "m",
        (0.1, 20.0),
        "nobody is looked for nearer to the camera; lower: nearer people are found, and more "
        "time is taken",
    )
    farthest_m: float = setting(
        25.0,
        "m",
        (2.0, 200.0),
        "nobody is looked for farther away; higher: far people are found, with less certain places",
    )
    tallest_m: float = setting(
        2.2,
        "m",
        (1.0, 3.0),
        "nothing higher over the floor is looked at; lower: less time, tall people may lose "
        "their heads",
    )
    window_px: int = setting(
        9,
        "px",
        (5, 31),
        "side of the square in which both eyes are compared, odd; higher: less noise, thin "
        "things and edges blur",
        odd=True,
    )
