"""The colours of tracks: distinct for the colour-blind."""

from __future__ import annotations

import tomllib
from importlib.resources import files
from typing import Final

from app.core.scenes import Colour


def colour_of_code(code: str) -> Colour:
    """`#rrggbb` as three numbers."""
    return int(code[1:3], 16), int(code[3:5], 16), int(code[5:7], 16)


def _read() -> tuple[Colour, ...]:
    text = (files("resources") / "themes" / "people.toml").read_text(encoding="utf-8")
    return tuple(map(colour_of_code, tomllib.loads(text)["colours"]))


TRACK_COLOURS: Final = _read()
"""Chosen among Okabe and Ito's and Tol's sets and a few more, so that the nearest two lie as far
apart as can be, in CIELAB, for normal, red-blind and green-blind eyes alike, and none of them
near the colours of errors; then ordered so that ids close to each other, who often walk close to
each other, differ most, and two of one hue, as violet and lilac, lie six apart. The second twelve
are the same hues, each lighter or darker. Sessions keep a colour's place, so places are not moved.
`tests/benchmarks/palette.py` measures them by CIEDE2000."""
NOBODY: Colour = (150, 150, 150)


def usual_place(track: int) -> int:
    """Which of the colours goes with a track's number; see `TrackColours`, which may differ."""
    return (track - 1) % len(TRACK_COLOURS)
