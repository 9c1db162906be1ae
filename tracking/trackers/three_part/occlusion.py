"""Which parts are hidden: by other people, and by what is drawn in the picture."""

from __future__ import annotations

import numpy as np

from tracking.trackers.three_part.people import Flags, Floats

_TOUCH = 1.25
"""Parts touch where their inner rectangles, larger by this, overlap."""
_STAYS = 0.08
"""By how much less alike somebody in front must look to change places with who was behind."""
_NEARER = 1.0
_CLEARLY = 0.2
"""How much standing lower by a body's height counts, and by how much it counts at most."""
_COVERED = 0.5
"""Share of a rectangle that a drawn outline must hold for it to hide the part."""
_SEEN = 0.4
"""Share of foreground in a covered rectangle from which on the person walks in front."""


def behind_what_is_drawn(cover: Floats, support: Floats) -> Flags:
    """(people, parts) hidden by what is drawn: covered by it, and nothing of them is seen.

    [ZhaoLee2009] section 4.3.2. A covered part on foreground is before the thing drawn.

    Args:
        cover: (people, parts) share of each rectangle within an outline.
        support: (people, parts) share of it on foreground.
    """
    return np.asarray((cover >= _COVERED) & (support < _SEEN))


def behind_others(
    rectangles: Floats, alike: Floats, foot: Floats, height: Floats, was_behind: Flags
) -> tuple[Flags, Flags]:
    """(people, parts) hidden by somebody else, and (people,) who touches somebody.

    [ZhaoLee2009] section 4.3.1: where parts of two people touch, the one whose parts look less
    like their models is the occluded one. Where we differ: all touching parts of the two are
    looked at together, as one is before the other as a whole; who stands lower in the picture is
    nearer to a camera that looks down, which tells before anything is hidden; and who is behind
    stays so unless the other looks clearly less like itself, as two alike would change places in
    every frame.

    Args:
        rectangles: (people, parts, 4) as predicted.
        alike: (people, parts) similarity there, less the usual one.
        foot: (people,) rows in which people stand. height: (people,) px.
        was_behind: (people,) who was hidden in the last frame.
    """
    touch = _touching(rectangles)
    own = np.asarray(touch.any(axis=3))  # person, part, other person
    parts = np.maximum(own.sum(axis=1), 1)
    look = np.einsum("pk,pkq->pq", alike, own) / parts
    bias = _STAYS * (was_behind[:, None].astype(float) - was_behind[None, :])
    lower = (foot[:, None] - foot[None]) * 2.0 / (height[:, None] + height[None])
    nearer = _NEARER * np.clip(lower, -_CLEARLY, _CLEARLY)
    behind = own.any(axis=1) & (look - look.T + nearer < bias)
    hidden = np.asarray(np.any(own & behind[:, None, :], axis=2))
    return hidden, np.asarray(own.any(axis=(1, 2)))


def _touching(rectangles: Floats) -> Flags:
    """(people, parts, people, parts) whose rectangles overlap; nobody touches themselves."""
    people, parts = rectangles.shape[:2]
    flat = rectangles.reshape(-1, 4)
    gap = np.abs(flat[:, None, :2] - flat[None, :, :2])
    reach = _TOUCH * (flat[:, None, 2:] + flat[None, :, 2:]) / 2
    touch = np.asarray((gap < reach).all(axis=2)).reshape(people, parts, people, parts)
    touch[np.arange(people), :, np.arange(people), :] = False
    return np.asarray(touch)
