"""Boxes that are suggested in a picture, as it draws them."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes import Colour


@dataclass(frozen=True, slots=True)
class SuggestedMark:
    """A box that no track has yet: dashed.

    Attributes:
        box: left, top, width, height in pixels as recorded.
        label: whose it would be, "" for a new person's. colour: theirs.
        ghost: it is where somebody was last, not what was found.
    """

    box: tuple[float, float, float, float]
    label: str
    colour: Colour
    ghost: bool = False
