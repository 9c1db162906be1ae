"""Tracks as a picture for notebooks, without any other library."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tracking.atomic_output import replace_with
from tracking.library.paths import AnyPath, as_path
from tracking.library.tables import Tracks, table_of
from tracking.recording import Recording
from tracking.tracks import Columns

_WIDTH, _HEIGHT, _MARGIN = 640.0, 480.0, 48.0
_COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#5b5b5b")
"""Of Okabe and Ito: told apart by everybody; they are repeated."""


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture as SVG; a notebook shows it.

    Attributes:
        svg: its text.
    """

    svg: str

    def _repr_svg_(self) -> str:
        """For notebooks."""
        return self.svg

    def save(self, path: AnyPath) -> Path:
        """Write it. Raises OutputError where that is not possible."""
        place = as_path(path)
        replace_with(place, self.svg.encode())
        return place


def plot(tracks: Tracks | Recording) -> Picture:
    """Draw the paths of people: on the floor in metres, or in pixels where no floor is known.

    Args:
        tracks: what `to_pandas` takes.

    Raises:
        FormatError, SessionError: a file cannot be read.
    """
    columns = table_of(tracks).columns
    on_floor = bool(np.isfinite(columns["x"]).any())
    across, up = _places(columns, on_floor=on_floor)
    known = np.isfinite(across) & np.isfinite(up)
    box = _Frame(across[known], up[known])
    lines = [
        _path(box, across[own & known], up[own & known], columns["track"][own][0])
        for own in (columns["track"] == track for track in np.unique(columns["track"]))
        if (own & known).any()
    ]
    unit = "m" if on_floor else "px"
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" '
        f'width="{_WIDTH:g}" height="{_HEIGHT:g}" font-family="sans-serif" font-size="12">'
        f'<rect width="100%" height="100%" fill="white"/>'
    )
    return Picture("\n".join([head, *box.axes(unit), *lines, "</svg>"]))


def _places(columns: Columns, *, on_floor: bool) -> tuple[np.ndarray, np.ndarray]:
    """Across and up: places on the floor, or where boxes stand in the picture."""
    if on_floor:
        return columns["x"], columns["y"]
    feet = columns["top"] + columns["height"]
    return columns["left"] + columns["width"] / 2, -feet


class _Frame:
    """Where places stand in the picture: the same scale across and up."""

    def __init__(self, across: np.ndarray, up: np.ndarray) -> None:
        low = np.array([across.min(initial=0.0), up.min(initial=0.0)])
        high = np.array([across.max(initial=1.0), up.max(initial=1.0)])
        if len(across):
            low, high = np.array([across.min(), up.min()]), np.array([across.max(), up.max()])
        room = np.array([_WIDTH, _HEIGHT]) - 2 * _MARGIN
        self._scale = float((room / np.maximum(high - low, 1e-6)).min())
        self._low, self._high = low, high

    def places(self, across: np.ndarray, up: np.ndarray) -> list[str]:
        """Each as "x,y" px."""
        x = _MARGIN + (across - self._low[0]) * self._scale
        y = _HEIGHT - _MARGIN - (up - self._low[1]) * self._scale
        return [f"{one:.1f},{other:.1f}" for one, other in zip(x, y, strict=True)]

    def axes(self, unit: str) -> list[str]:
        """The extent at both axes."""
        bottom = _HEIGHT - _MARGIN
        (left, low), (right, high) = self._low, self._high
        end = _MARGIN + (right - left) * self._scale
        top = bottom - (high - low) * self._scale
        return [
            f'<path d="M{_MARGIN:g} {top:.1f}V{bottom:g}H{end:.1f}" fill="none" stroke="#888"/>',
            _text(_MARGIN, bottom + 18, f"{left:.4g} {unit}", "start"),
            _text(end, bottom + 18, f"{right:.4g} {unit}", "end"),
            _text(_MARGIN - 6, bottom, f"{abs(low):.4g}", "end"),
            _text(_MARGIN - 6, top + 10, f"{abs(high):.4g}", "end"),
        ]


def _text(x: float, y: float, said: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="#444">{said}</text>'


def _path(frame: _Frame, across: np.ndarray, up: np.ndarray, track: int) -> str:
    places = frame.places(across, up)
    colour = _COLOURS[int(track) % len(_COLOURS)]
    x, y = places[-1].split(",")
    line = (
        f'<polyline points="{" ".join(places)}" fill="none" stroke="{colour}" stroke-width="1.5"/>'
    )
    return f'{line}<text x="{x}" y="{y}" dx="4" fill="{colour}">{int(track)}</text>'
