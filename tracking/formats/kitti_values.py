"""What KITTI's labels say in words and codes, and what stands for a number that is not known."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.formats.mot_classes import CLASS
from tracking.tracks import TrackLabel

PERSON, DONT_CARE, OTHER = "Pedestrian", "DontCare", "Misc"
TYPES = (PERSON, "Car", "Van", "Truck", "Person", "Person_sitting", "Cyclist", "Tram", OTHER)

UNKNOWN_SIDE, UNKNOWN_ANGLE, UNKNOWN_PLACE = -1, -10, -1000

VISIBILITY = np.array([1.0, 0.5, 0.1, np.nan])
"""How much is seen, by KITTI's occlusion: nothing hidden, a part, most of it, unknown."""
UNKNOWN_OCCLUSION = 3

_IN_LOWER_CASE = {name.lower(): name for name in TYPES}


def occlusion_of(visibility: NDArray[Any]) -> NDArray[np.int64]:
    """(n,) KITTI's number for how much of each is seen, the nearest one.

    Where nobody knows, all is: scorers leave out people of whom it is said to be unknown.
    """
    seen = np.where(np.isnan(visibility), 1.0, visibility)
    off = np.abs(seen[:, None] - VISIBILITY[:UNKNOWN_OCCLUSION])
    return np.asarray(off.argmin(axis=1), np.int64)


def kept_visibility(visibility: NDArray[Any], _predicted: NDArray[Any]) -> NDArray[np.float64]:
    """(n,) what is left of visibilities that were written."""
    return VISIBILITY[occlusion_of(visibility)]


def label_of_type(name: str) -> TrackLabel:
    """What a track's label says of its type; nothing of people."""
    return TrackLabel() if name == PERSON else TrackLabel(attributes={CLASS: name})


def type_of_label(label: TrackLabel) -> str:
    """KITTI's word for a track's class; people where the label says nothing of it."""
    name = label.attributes.get(CLASS, PERSON).strip().lower()
    return PERSON if name == "person" else _IN_LOWER_CASE.get(name, OTHER)
