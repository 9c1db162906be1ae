"""Settings of the background model and of shadow removal."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class ForegroundSettings:
    """What counts as foreground, how fast the background follows, and what counts as shadow."""

    threshold: float = field(
        default=16.0,
        metadata={
            "unit": "grey levels",
            "range": (2.0, 100.0),
            "help": "smallest difference from the background that is foreground",
        },
    )
    noise_factor: float = field(
        default=4.0,
        metadata={
            "unit": "",
            "range": (0.0, 20.0),
            "help": "a pixel must also differ by this many times its own usual deviation",
        },
    )
    adapt_s: float = field(
        default=10.0,
        metadata={
            "unit": "s",
            "range": (0.5, 600.0),
            "help": "time in which the background follows slow changes of light",
        },
    )
    absorb_s: float = field(
        default=3.0,
        metadata={
            "unit": "s",
            "range": (0.2, 600.0),
            "help": "a still change that is nobody (ghost, moved chair) joins the background",
        },
    )
    absorb_person_s: float = field(
        default=180.0,
        metadata={
            "unit": "s",
            "range": (10.0, 36000.0),
            "help": "a thing as high as a person that keeps still so long joins the background",
        },
    )
    learn_s: float = field(
        default=1.5,
        metadata={
            "unit": "s",
            "range": (0.0, 60.0),
            "help": "at the start, changes join the background this much sooner",
        },
    )
    updates_hz: float = field(
        default=4.0,
        metadata={
            "unit": "Hz",
            "range": (0.5, 60.0),
            "help": "how often the background is updated",
        },
    )
    scene_change: float = field(
        default=0.7,
        metadata={
            "unit": "share",
            "range": (0.2, 1.0),
            "help": "more foreground than this is a change of the whole scene, not people",
        },
    )
    shadow_threshold: float = field(
        default=0.42,
        metadata={
            "unit": "",
            "range": (0.0, 1.0),
            "help": "foreground with a shadow score below this is shadow",
        },
    )
    floor_shadow_threshold: float = field(
        default=0.75,
        metadata={
            "unit": "",
            "range": (0.0, 1.0),
            "help": "the same for foreground that range puts on the floor",
        },
    )
    shadow_texture: float = field(
        default=0.45,
        metadata={"unit": "", "range": (0.0, 1.0), "help": "alpha: weight of the texture"},
    )
    shadow_hue: float = field(
        default=0.45,
        metadata={"unit": "", "range": (0.0, 1.0), "help": "beta: weight of the hue"},
    )
    shadow_constant: float = field(
        default=0.2,
        metadata={"unit": "", "range": (0.0, 1.0), "help": "eta: the scene's constant"},
    )
    shadow_darkest: float = field(
        default=0.25,
        metadata={
            "unit": "share",
            "range": (0.0, 1.0),
            "help": "what keeps less than this of the background's light is no shadow",
        },
    )
