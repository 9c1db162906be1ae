"""Two files of one pair of cameras, told by their names."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

_SIDES = (("left", "right"), ("links", "rechts"), ("gauche", "droite"))
_PARTS = re.compile(r"[A-Za-z]+|[0-9]+|[^A-Za-z0-9]+")
_GOPRO = re.compile(r"(G[XHLPO]|GOPR)(\d{2})?(\d{4})", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class NamedPair:
    """Two files that belong together.

    Attributes:
        left, right: by their names, where these tell.
        sides_told: the names say which is which; else the first in order stands as the left one.
    """

    left: Path
    right: Path
    sides_told: bool


def pair_by_name(files: Sequence[Path]) -> NamedPair | None:
    """The two files whose names differ in the side, or in the number of the camera, alone.

    Known are left and right, L and R, cam0 and cam1 and any other two numbers one apart, and the
    chapters of two GoPro cameras. None: no two files are so, or several pairs are.
    """
    found = [
        pair
        for row, one in enumerate(files)
        for other in files[row + 1 :]
        if (pair := _pair(one, other)) is not None
    ]
    told = [pair for pair in found if pair.sides_told] or found
    return told[0] if len(told) == 1 else None


def _pair(one: Path, other: Path) -> NamedPair | None:
    """These two as a pair; None where their names differ in more."""
    if one.suffix.lower() != other.suffix.lower() and not (one.is_dir() or other.is_dir()):
        return None
    parts = [_PARTS.findall(file.stem.lower()) for file in (one, other)]
    if len(parts[0]) != len(parts[1]):
        return _gopro(one, other)
    differing = [pair for pair in zip(*parts, strict=True) if pair[0] != pair[1]]
    if len(differing) != 1:
        return _gopro(one, other)
    first, second = differing[0]
    for left, right in (*_SIDES, ("l", "r")):
        if {first, second} == {left, right}:
            return NamedPair(one, other, True) if first == left else NamedPair(other, one, True)
    if first.isdigit() and second.isdigit() and abs(int(first) - int(second)) == 1:
        lower = one if int(first) < int(second) else other
        return NamedPair(lower, other if lower is one else one, False)
    return _gopro(one, other)


def _gopro(one: Path, other: Path) -> NamedPair | None:
    """Two GoPro videos: of two cameras that were started together numbers may differ by more."""
    if _GOPRO.fullmatch(one.stem) is None or _GOPRO.fullmatch(other.stem) is None:
        return None
    first, second = sorted((one, other), key=lambda file: file.stem.lower())
    return NamedPair(first, second, False)
