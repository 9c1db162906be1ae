"""Settings of telling people apart and measuring them."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class PeopleSettings:
    """What a person looks like in metres."""

    least_area_m2: float = setting(
        0.04, "m²", (0.01, 1.0), "less visible surface than this is nobody"
    )
    lowest_m: float = setting(
        0.3, "m", (0.05, 1.0), "points below tell nobody from shadows and flecks on the floor"
    )
    least_height_m: float = setting(0.9, "m", (0.3, 1.5), "nobody's top is lower")
    body_width_m: float = setting(0.5, "m", (0.2, 1.0), "breadth of a person")
    body_height_m: float = setting(
        1.75, "m", (0.8, 2.2), "height assumed of a person whose head or feet are not seen"
    )
    body_depth_m: float = setting(
        0.07, "m", (0.0, 0.4), "a person's middle lies this far behind the surface that is seen"
    )
    merged_ratio: float = setting(
        1.6,
        "",
        (1.0, 4.0),
        "a region this many times wider or higher than a person is several people",
    )
    disparity_noise_px: float = setting(
        0.2,
        "px",
        (0.02, 3.0),
        "spread of disparity; how far apart in range people must be to be told apart",
    )
    hue_bins: int = setting(16, "", (4, 64), "bins of hue in histograms")
    saturation_bins: int = setting(4, "", (1, 16), "bins of saturation in histograms")
