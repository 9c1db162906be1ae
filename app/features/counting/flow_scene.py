"""The flow map as colours and arrows."""

from __future__ import annotations

from typing import TypeVar

import numpy as np

from app.core.colours.colour_scales import VIRIDIS
from app.core.i18n import tr
from app.core.scenes import LegendEntry
from app.core.scenes.flow_map import FlowScene
from app.features.counting.scene import Floats
from tracking.counting import FlowMap

Share = TypeVar("Share", float, Floats)
"""Of the highest density: one, or of each cell."""
_FAINTEST, _STRONGEST = 60, 190
_ARROW_S = 0.45
"""An arrow shows how far people get in this time, at most over its own cell."""
_STANDING_M_S = 0.1
_LEAST_SHARE = 0.02
"""Cells with less than this of the highest density get no arrow: a single person's way is noise."""


def flow_scene(flow: FlowMap) -> FlowScene:
    """Colours by the root of the density, so that thin flows show beside crowds; arrows upon it."""
    share = np.sqrt(flow.density / flow.most) if flow.most > 0 else flow.density
    image = np.zeros((*share.shape, 4), np.uint8)
    levels = np.round(255 * share).astype(np.uint8)
    image[..., :3] = VIRIDIS.table[levels]
    image[..., 3] = np.where(flow.density > 0, _opacity(share), 0).astype(np.uint8)
    return FlowScene(
        flow.left,
        flow.bottom,
        flow.cell_m,
        np.ascontiguousarray(image[::-1]),
        _arrows(flow),
        _legend(flow.most),
    )


def _opacity(share: Share) -> Share:
    """0..255 of roots of densities, as a share of the highest: thin flows hide the floor less."""
    return _FAINTEST + (_STRONGEST - _FAINTEST) * share


def _arrows(flow: FlowMap) -> Floats:
    """(n, 4) through the middles of the cells in which people go somewhere."""
    speed = np.hypot(flow.velocity[..., 0], flow.velocity[..., 1])
    shown = (speed > _STANDING_M_S) & (flow.density >= _LEAST_SHARE * flow.most)
    middle, velocity = flow.centres[shown], flow.velocity[shown]
    longest = 0.9 * flow.cell_m
    length = np.minimum(speed[shown] * _ARROW_S, longest)
    half = velocity / speed[shown][:, None] * (length / 2)[:, None]
    return np.column_stack((middle - half, middle + half))


def _legend(most: float) -> tuple[LegendEntry, ...]:
    """The colours of the highest density, of a quarter of it and of next to none."""
    if most <= 0:
        return ()
    entries = [
        LegendEntry(
            VIRIDIS.colour(share**0.5), _density_text(share * most), _opacity(share**0.5) / 255
        )
        for share in (1.0, 0.25, 0.0)
    ]
    return tuple(entries)


def _density_text(density: float) -> str:
    return tr("{density:.2g} people/m² on average", density=density)
