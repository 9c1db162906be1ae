"""Settings of telling people apart and measuring them."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class PeopleSettings:
    """What a person looks like in metres."""

    least_area_m2: float = setting(
        0.04,
        "m²",
        (0.01, 1.0),
        "less visible surface than this is nobody; higher: fewer false people, half hidden ones "
        "are missed",
    )
    lowest_m: float = setting(
        0.3,
        "m",
        (0.05, 1.0),
        "what is lower over the floor is left out, as shadows are; higher: fewer shadows taken "
        "for people, crouching ones are missed",
    )
    least_height_m: float = setting(
        0.9,
        "m",
        (0.3, 1.5),
        "nobody's top is lower; higher: fewer carts and bags taken for people, children are missed",
    )
    body_width_m: float = setting(
        0.5,
        "m",
        (0.2, 1.0),
        "how broad a person is; lower: groups are parted sooner, and one person into two",
    )
    body_height_m: float = setting(
        1.75, "m", (0.8, 2.2), "height taken for a person whose head or feet are not seen"
    )
    body_depth_m: float = setting(
        0.07, "m", (0.0, 0.4), "how far a person's middle lies behind the surface the camera sees"
    )
    merged_ratio: float = setting(
        1.6,
        "",
        (1.0, 4.0),
        "a region this many times wider or higher than a person is several people; higher: "
        "groups are parted less often",
    )
    disparity_noise_px: float = setting(
        0.2,
        "px",
        (0.02, 3.0),
        "how much the measured shift between the eyes trembles; higher: people must be farther "
        "apart in depth to be told apart",
    )
    hue_bins: int = setting(
        16,
        "",
        (4, 64),
        "how finely colours are told apart; higher: more clothes differ, changing light does "
        "more harm",
    )
    saturation_bins: int = setting(
        4, "", (1, 16), "the same for how strong a colour is, from grey to full"
    )
    hue_by_saturation: bool = setting(
        True,
        "",
        None,
        "the stronger its colour, the more a spot of somebody's clothes counts; off, or with "
        "paper: each counts alike, and grey ones as red",
    )
