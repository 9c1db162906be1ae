"""Marks of the people of another version of the tracks."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes import Colour, Points


@dataclass(frozen=True, slots=True)
class OtherMark:
    """Somebody of the other session in a picture: a thin dashed box.

    Attributes:
        box: left, top, width, height in pixels of that camera. label: their id there.
        colour: of the person of the open session it is taken for.
    """

    box: tuple[float, float, float, float]
    label: str
    colour: Colour


@dataclass(frozen=True, slots=True)
class OtherPlace:
    """Somebody of the other session on the floor: a thin dashed trail, (n, 2) metres."""

    trail: Points
    label: str
    colour: Colour


@dataclass(frozen=True, slots=True)
class Divider:
    """Left of it the picture shows one of two compared versions, right of it the other.

    Attributes:
        share: of the picture that is left of it, 0..1. left, right: the versions by name.
    """

    share: float
    left: str
    right: str
