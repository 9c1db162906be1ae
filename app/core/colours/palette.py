"""The colours of tracks: distinct for the colour-blind."""

from __future__ import annotations

from app.core.scenes import Colour

# Chosen among Okabe and Ito's and Tol's sets and a few more, so that the nearest two lie as far
# apart as can be, in CIELAB, for normal, red-blind and green-blind eyes alike, and none of them
# near the colours of errors; then ordered so that ids close to each other, who often walk close to
# each other, differ most, and two of one hue, as violet and lilac, lie six apart.
_FIRST: tuple[Colour, ...] = (
    (110, 70, 180),
    (238, 221, 136),
    (238, 51, 119),
    (153, 221, 255),
    (50, 60, 240),
    (0, 153, 136),
    (200, 140, 255),
    (187, 204, 51),
    (238, 136, 102),
    (68, 119, 170),
    (255, 170, 187),
    (17, 119, 51),
)
# The second time around the same hues, each lighter or darker: by how much was searched for, so
# that no two of all lie close, for anybody's eyes.
_SECOND: tuple[Colour, ...] = (
    (168, 144, 210),
    (246, 238, 196),
    (107, 23, 54),
    (107, 155, 178),
    (25, 30, 120),
    (191, 230, 225),
    (110, 77, 140),
    (131, 143, 36),
    (167, 95, 71),
    (42, 74, 105),
    (115, 76, 84),
    (136, 187, 153),
)

TRACK_COLOURS: tuple[Colour, ...] = (*_FIRST, *_SECOND)
NOBODY: Colour = (150, 150, 150)


def usual_place(track: int) -> int:
    """Which of the colours goes with a track's number; see `TrackColours`, which may differ."""
    return (track - 1) % len(TRACK_COLOURS)
