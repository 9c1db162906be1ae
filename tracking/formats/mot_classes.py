"""The classes of MOTChallenge's truth from 2016 on ([Milan2016], table 6)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import TrackLabel
from tracking.translation import msg

PERSON = 1
NAMES: Mapping[int, str] = {
    PERSON: "pedestrian",
    2: "person on vehicle",
    3: "car",
    4: "bicycle",
    5: "motorbike",
    6: "non-motorized vehicle",
    7: "static person",
    8: "distractor",
    9: "occluder",
    10: "occluder on the ground",
    11: "full occluder",
    12: "reflection",
    13: "crowd",
}
_NUMBERS = {name: number for number, name in NAMES.items()}
CLASS = "class"
"""The attribute of a track that says what kind of thing it is; a person has none."""


def labels_of_classes(track: NDArray[Any], kind: NDArray[Any]) -> dict[int, TrackLabel]:
    """Labels of the tracks that are of another class than people, by their first row."""
    other = np.isfinite(kind) & (kind != PERSON) & np.isfinite(track)
    tracks, first = np.unique(track[other], return_index=True)
    kinds = kind[other][first]
    return {
        int(each): TrackLabel(
            attributes={CLASS: NAMES.get(int(number), msg("class {number:g}", number=number))}
        )
        for each, number in zip(tracks.tolist(), kinds.tolist(), strict=True)
    }


def kept_visibility(visibility: NDArray[Any], _predicted: NDArray[Any]) -> NDArray[np.float64]:
    """(n,) visibilities as they are written: where nobody knows, all is seen."""
    return np.where(np.isnan(visibility), 1.0, visibility)


def class_of_label(label: TrackLabel) -> int:
    """The number of a track's class; people where the label says nothing that is known."""
    name = label.attributes.get(CLASS, "").strip().lower()
    if name.startswith("class ") and name[6:].isdecimal():
        return int(name[6:])
    return _NUMBERS.get(name, PERSON)
