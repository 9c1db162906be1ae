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
        "how different from the background a pixel must be; higher: less noise and shadow, pale "
        "clothes are missed",
    )
    noise_factor: float = setting(
        4.0,
        "",
        (0.0, 20.0),
        "the same in multiples of how much the pixel usually flickers; higher: flickering lamps "
        "and leaves are ignored",
    )
    adapt_s: float = setting(
        10.0,
        "s",
        (0.5, 600.0),
        "how fast the background follows slow changes of light; higher: slower, standing people "
        "stay people longer",
    )
    absorb_s: float = setting(
        3.0,
        "s",
        (0.2, 600.0),
        "how long a still thing that is nobody, such as a moved chair, stands out before it is "
        "background; higher: longer",
    )
    absorb_person_s: float = setting(
        180.0,
        "s",
        (10.0, 36000.0),
        "the same for a thing as high as a person; higher: people who stand very still are seen "
        "longer",
    )
    learn_s: float = setting(
        1.5,
        "s",
        (0.0, 60.0),
        "at the start, changes become background this much sooner; higher: who stands there at "
        "the start fades sooner once they walk",
    )
    updates_hz: float = setting(
        4.0,
        "Hz",
        (0.5, 60.0),
        "how often the background is brought up to date; higher: follows light more closely and "
        "takes more time",
    )
    scene_change: float = setting(
        0.7,
        "share",
        (0.2, 1.0),
        "when more of the picture than this has changed, the whole scene did (light, camera), "
        "and nobody is looked for; higher: only when nearly all has",
    )
    shadow_threshold: float = setting(
        0.42,
        "",
        (0.0, 1.0),
        "what looks less like a person than this, from 0 (shadow) to 1, is taken for shadow; "
        "higher: more shadow is removed, and more of dark clothes",
    )
    floor_shadow_threshold: float = setting(
        0.75,
        "",
        (0.0, 1.0),
        "the same for what lies flat on the floor by its distance; higher: more shadow is "
        "removed there",
    )
    shadow_texture: float = setting(
        0.45,
        "",
        (0.0, 1.0),
        "how much it counts that a shadow keeps the floor's pattern (alpha); higher: pattern "
        "decides",
    )
    shadow_hue: float = setting(
        0.45,
        "",
        (0.0, 1.0),
        "how much it counts that a shadow keeps the floor's colour (beta); higher: colour decides",
    )
    shadow_constant: float = setting(
        0.2,
        "",
        (0.0, 1.0),
        "counted for every pixel as no shadow (eta); higher: less is taken for shadow",
    )
    shadow_darkest: float = setting(
        0.25,
        "share",
        (0.0, 1.0),
        "what is darker than this share of the background is no shadow; higher: deep shadows "
        "stay foreground",
    )
