"""Settings of telling people apart and measuring them."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class PeopleSettings:
    """What a person looks like in metres."""

    min_area_m2: float = setting(
        0.04,
        "m²",
        (0.01, 1.0),
        "Smallest visible surface of a person; higher: fewer false detections, but people who "
        "are half occluded are missed",
        formerly=("least_area_m2",),
    )
    min_point_height_m: float = setting(
        0.3,
        "m",
        (0.05, 1.0),
        "Points below this height above the floor are ignored, as they may be shadow; higher: "
        "fewer shadows are detected as people, but crouching people are missed",
        formerly=("lowest_m",),
        expert=True,
    )
    min_height_m: float = setting(
        0.9,
        "m",
        (0.3, 1.5),
        "Smallest body height of a person; higher: fewer carts and bags are detected as people, "
        "but children are missed",
        formerly=("least_height_m",),
    )
    body_width_m: float = setting(
        0.5,
        "m",
        (0.2, 1.0),
        "Width of a person; lower: groups are split sooner, and so are single people",
    )
    body_height_m: float = setting(
        1.75,
        "m",
        (0.8, 2.2),
        "Body height of a person whose head or feet are not visible; higher: such people are "
        "taken to be taller",
        expert=True,
    )
    body_depth_m: float = setting(
        0.07,
        "m",
        (0.0, 0.4),
        "Distance from the visible surface of a person to the centre of the body; higher: "
        "positions move away from the cameras",
        expert=True,
    )
    merged_ratio: float = setting(
        1.6,
        "",
        (1.0, 4.0),
        "A region this many times as wide or as high as a person holds several people; higher: "
        "groups are split less often",
        expert=True,
    )
    disparity_noise_px: float = setting(
        0.2,
        "px",
        (0.02, 3.0),
        "Standard deviation of the measured disparity; higher: people are separated only when "
        "they are farther apart in depth",
        expert=True,
    )
    hue_bins: int = setting(
        16,
        "",
        (4, 64),
        "Histogram bins for hue; higher: clothes differ more clearly, but changing light does "
        "more harm",
        expert=True,
    )
    saturation_bins: int = setting(
        4,
        "",
        (1, 16),
        "Histogram bins for saturation; higher: clothes differ more clearly, but changing light "
        "does more harm",
        expert=True,
    )
    hue_by_saturation: bool = setting(
        True,
        "",
        None,
        "Weight the hue of each pixel by its saturation. Off, or with paper: all pixels count "
        "alike, and grey counts as red",
        expert=True,
    )
