"""The colours of tracks: distinct for the colour-blind."""

from __future__ import annotations

import tomllib
from importlib.resources import files
from typing import Final

from app.core.scenes import Colour


def colour_of_code(code: str) -> Colour:
    """`#rrggbb` as three numbers."""
    return int(code[1:3], 16), int(code[3:5], 16), int(code[5:7], 16)


def _read(name: str) -> tuple[Colour, ...]:
    text = (files("resources") / "themes" / "people.toml").read_text(encoding="utf-8")
    return tuple(map(colour_of_code, tomllib.loads(text)[name]))


TRACK_COLOURS: Final = _read("colours")
"""Found by `python -m tests.benchmarks.palette --search`: those that look most alike to usual eyes
or to the colour-blind (CIEDE2000) differ as much as can be, ids near each other most, and all
stand out from what they are drawn on and from the colours of errors. Sessions keep their places."""
LIGHT_COLOURS: Final = dict(zip(TRACK_COLOURS, _read("light"), strict=True))
"""What stands for each on the grounds of the light look, which would swallow it; of its hue."""
NOBODY: Colour = (150, 150, 150)


def usual_place(track: int) -> int:
    """Which of the colours goes with a track's number; see `TrackColours`, which may differ."""
    return (track - 1) % len(TRACK_COLOURS)
