"""In which group of the form a tracker's own setting stands."""

from __future__ import annotations

from typing import Final

from app.core.i18n import N_, tr

_GROUPS: Final = (
    (N_("Particles and motion"), ("particle", "initial_spread", "max_spread", "process_noise")),
    (N_("Particles and motion"), ("measurement_noise", "velocity")),
    (N_("Association"), ("appearance", "association", "colour", "cost", "direction", "distance")),
    (N_("Association"), ("gate", "miss_probability", "model", "occlusion_weight", "reidentify")),
    (N_("Association"), ("similarity",)),
    (N_("Track management"), ("birth", "coast", "confirm", "delete", "extrapolate", "merge")),
    (N_("Track management"), ("min_visibility", "negative_information", "persistent", "report")),
    (N_("Bodies"), ("adjust", "body", "fit", "initial_height", "max_height", "min_height")),
    (N_("Bodies"), ("min_separation", "pose", "radius", "region")),
)
"""Beginnings of names; of several that fit, the longest counts."""
_OTHERS = N_("Result")


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
