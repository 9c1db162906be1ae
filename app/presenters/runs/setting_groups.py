"""In which group of the form a tracker's own setting stands."""

from __future__ import annotations

from typing import Final

from app.presenters.i18n import tr

_GROUPS: Final = (
    ("Particles and motion", ("particle", "spread", "start_spread", "largest_spread")),
    ("Particles and motion", ("sigma", "velocity", "agility", "slowing")),
    ("Who is whom", ("colour", "direction", "looks", "distance", "gate", "cost", "similarity")),
    ("Who is whom", ("model", "hidden_weight", "least_margin", "find_again", "overlooked")),
    ("Coming and going", ("birth", "confirm", "new", "lost", "remember", "unseen", "hidden")),
    ("Coming and going", ("unproven", "empty", "led", "walked", "hold", "closest")),
    ("Bodies", ("radius", "least_height", "most_height", "usual_height", "region", "apart")),
    ("Bodies", ("body", "adjust", "follow", "silhouettes")),
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
