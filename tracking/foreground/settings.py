"""Settings of the background model and of shadow removal."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.setting import setting


@dataclass(frozen=True, slots=True)
class ForegroundSettings:
    """What counts as foreground, how fast the background follows, and what counts as shadow."""

    threshold: float = setting(
        16.0,
        "grey levels",
        (2.0, 100.0),
        "smallest difference from the background that is foreground",
    )
    noise_factor: float = setting(
        4.0, "", (0.0, 20.0), "a pixel must also differ by this many times its own usual deviation"
    )
    adapt_s: float = setting(
        10.0, "s", (0.5, 600.0), "time in which the background follows slow changes of light"
    )
    absorb_s: float = setting(
        3.0,
        "s",
        (0.2, 600.0),
        "a still change that is nobody (ghost, moved chair) joins the background",
    )
    absorb_person_s: float = setting(
        180.0,
        "s",
        (10.0, 36000.0),
        "a thing as high as a person that keeps still so long joins the background",
    )
    learn_s: float = setting(
        1.5, "s", (0.0, 60.0), "at the start, changes join the background this much sooner"
    )
    updates_hz: float = setting(4.0, "Hz", (0.5, 60.0), "how often the background is updated")
    scene_change: float = setting(
        0.7,
        "share",
        (0.2, 1.0),
        "more foreground than this is a change of the whole scene, not people",
    )
    shadow_threshold: float = setting(
        0.42, "", (0.0, 1.0), "foreground with a shadow score below this is shadow"
    )
    floor_shadow_threshold: float = setting(
        0.75, "", (0.0, 1.0), "the same for foreground that range puts on the floor"
    )
    shadow_texture: float = setting(0.45, "", (0.0, 1.0), "alpha: weight of the texture")
    shadow_hue: float = setting(0.45, "", (0.0, 1.0), "beta: weight of the hue")
    shadow_constant: float = setting(0.2, "", (0.0, 1.0), "eta: the scene's constant")
    shadow_darkest: float = setting(
        0.25,
        "share",
        (0.0, 1.0),
        "what keeps less than this of the background's light is no shadow",
    )
