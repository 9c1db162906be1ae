"""In which group of the form a tracker's own setting stands."""

from __future__ import annotations

from typing import Final

from app.core.i18n import tr

_GROUPS: Final = (
    ("Particles and motion", ("particle", "initial_spread", "max_spread", "process_noise")),
    ("Particles and motion", ("measurement_noise", "velocity")),
    ("Association", ("appearance", "association", "colour", "cost", "direction", "distance")),
    ("Association", ("gate", "miss_probability", "model", "occlusion_weight", "reidentify")),
    ("Association", ("similarity",)),
    ("Track management", ("birth", "coast", "confirm", "delete", "extrapolate", "merge")),
    ("Track management", ("min_visibility", "negative_information", "persistent", "report")),
    ("Bodies", ("adjust", "body", "fit", "initial_height", "max_height", "min_height")),
    ("Bodies", ("min_separation", "pose", "radius", "region")),
)
"""Beginnings of names; of several that fit, the longest counts."""
_OTHERS = "Result"


def group_of(name: str) -> str:
    """The heading above a setting of a tracker's own, by its name."""
    if name.endswith("_particles"):
        return tr(_GROUPS[0][0])
    fits = [
        (len(begin), title)
        for title, begins in _GROUPS
        for begin in begins
        if name.startswith(begin)
    ]
    return tr(max(fits)[1] if fits else _OTHERS)
