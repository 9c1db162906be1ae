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
        "Smallest difference from the background at which a pixel is foreground; higher: less "
        "noise and shadow, but people in pale clothes are missed",
    )
    noise_factor: float = setting(
        4.0,
        "",
        (0.0, 20.0),
        "The same threshold in multiples of the pixel's own noise; higher: flickering lamps and "
        "moving leaves are ignored",
        expert=True,
    )
    adapt_s: float = setting(
        10.0,
        "s",
        (0.5, 600.0),
        "Time constant with which the background follows slow changes of light; higher: slower "
        "updates, and standing people stay foreground longer",
        expert=True,
    )
    absorb_s: float = setting(
        3.0,
        "s",
        (0.2, 600.0),
        "Seconds until a still object that is no person, such as a moved chair, becomes "
        "background; higher: it stays foreground longer",
    )
    absorb_person_s: float = setting(
        180.0,
        "s",
        (10.0, 36000.0),
        "Seconds until a still object as tall as a person becomes background; higher: people who "
        "stand very still are detected longer",
    )
    updates_hz: float = setting(
        4.0,
        "Hz",
        (0.5, 60.0),
        "Background updates per second; higher: the background follows the light more closely "
        "and takes more time",
        expert=True,
    )
    scene_change: float = setting(
        0.7,
        "share",
        (0.2, 1.0),
        "Share of foreground pixels above which the whole scene has changed (light, camera) and "
        "the frame has no detections; higher: only larger changes count",
        expert=True,
    )
    shadow_threshold: float = setting(
        0.42,
        "",
        (0.0, 1.0),
        "Pixels with a score below this are shadow (0: shadow, 1: person); higher: more shadow "
        "is removed, and more of dark clothes",
    )
    floor_shadow_threshold: float = setting(
        0.75,
        "",
        (0.0, 1.0),
        "The same threshold for pixels whose distance places them on the floor; higher: more "
        "shadow is removed there",
        expert=True,
    )
    shadow_texture: float = setting(
        0.45,
        "",
        (0.0, 1.0),
        "Weight of texture in the shadow score (alpha): a shadow keeps the texture of the "
        "floor; higher: texture decides",
        expert=True,
    )
    shadow_hue: float = setting(
        0.45,
        "",
        (0.0, 1.0),
        "Weight of hue in the shadow score (beta): a shadow keeps the hue of the floor; higher: "
        "hue decides",
        expert=True,
    )
    shadow_constant: float = setting(
        0.2,
        "",
        (0.0, 1.0),
        "Constant part of the shadow score (eta); higher: fewer pixels are shadow",
        expert=True,
    )
    shadow_min_brightness: float = setting(
        0.25,
        "share",
        (0.0, 1.0),
        "Pixels darker than this share of the background are not shadow; higher: deep shadows "
        "stay foreground",
        formerly=("shadow_darkest",),
        expert=True,
    )
