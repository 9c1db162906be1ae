"""Settings of telling people apart and measuring them."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class PeopleSettings:
    """What a person looks like in metres."""

    least_area_m2: float = field(
        default=0.04,
        metadata={
            "unit": "m²",
            "range": (0.01, 1.0),
            "help": "less visible surface than this is nobody",
        },
    )
    lowest_m: float = field(
        default=0.3,
        metadata={
            "unit": "m",
            "range": (0.05, 1.0),
            "help": "points below tell nobody from shadows and flecks on the floor",
        },
    )
    least_height_m: float = field(
        default=0.9,
        metadata={"unit": "m", "range": (0.3, 1.5), "help": "nobody's top is lower"},
    )
    body_width_m: float = field(
        default=0.5,
        metadata={"unit": "m", "range": (0.2, 1.0), "help": "breadth of a person"},
    )
    body_height_m: float = field(
        default=1.75,
        metadata={
            "unit": "m",
            "range": (0.8, 2.2),
            "help": "height assumed of a person whose head or feet are not seen",
        },
    )
    body_depth_m: float = field(
        default=0.07,
        metadata={
            "unit": "m",
            "range": (0.0, 0.4),
            "help": "a person's middle lies this far behind the surface that is seen",
        },
    )
    merged_ratio: float = field(
        default=1.6,
        metadata={
            "unit": "",
            "range": (1.0, 4.0),
            "help": "a region this many times wider or higher than a person is several people",
        },
    )
    disparity_noise_px: float = field(
        default=0.35,
        metadata={
            "unit": "px",
            "range": (0.02, 3.0),
            "help": "spread of disparity; how far apart in range people must be to be told apart",
        },
    )
    hue_bins: int = field(
        default=16, metadata={"unit": "", "range": (4, 64), "help": "bins of hue in histograms"}
    )
    saturation_bins: int = field(
        default=4,
        metadata={"unit": "", "range": (1, 16), "help": "bins of saturation in histograms"},
    )
