"""Samples of the failure detector: features of an instant and whether a part was lost there."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.failure.features import FEATURES, Floats

TEXT = np.dtype(object)
"""Stands for a column of text."""

SAMPLE_COLUMNS: Mapping[str, np.dtype[Any]] = MappingProxyType(
    {
        "recording": TEXT,  # its name
        "track": np.dtype(np.int32),
        "frame": np.dtype(np.int32),
        "part": np.dtype(np.uint8),  # 0 head, 1 torso, 2 hip-leg
        "label": np.dtype(np.uint8),  # 1 on its part, 0 off its part
        "author": TEXT,  # who labelled it; "" where nobody knows
        "reason": TEXT,  # why it was suggested to them; "" where it was not
        "source": TEXT,  # one of `SAMPLE_SOURCES`
    }
)
SAMPLE_SOURCES = ("label", "correction", "truth")
"""A rectangle somebody judged, one that somebody put right, one judged by rendered truth."""


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Samples, a row each; n rows.

    Attributes:
        columns: `SAMPLE_COLUMNS`, (n,) each.
        features: (n, 36), see `FEATURE_NAMES`; all finite.
    """

    columns: Mapping[str, NDArray[Any]]
    features: Floats

    def __len__(self) -> int:
        """How many there are."""
        return len(self.features)

    def __getitem__(self, rows: NDArray[Any] | slice) -> Samples:
        """Some of them, by mask, index or slice."""
        columns = {name: column[rows] for name, column in self.columns.items()}
        return Samples(columns, self.features[rows])

    def counts(self) -> NDArray[np.int64]:
        """(3, 2) how many samples of each part are off it and on it."""
        place = self.columns["part"].astype(np.int64) * 2 + self.columns["label"]
        return np.bincount(place, minlength=6).reshape(3, 2)

    def people(self) -> NDArray[np.int64]:
        """(n,) a number for each recording and person in it, from 0 on."""
        pairs = list(zip(*(self.columns[name].tolist() for name in _PERSON), strict=True))
        number = {pair: at for at, pair in enumerate(sorted(set(pairs)))}
        return np.array([number[pair] for pair in pairs], np.int64)


_PERSON = ("recording", "track")


def no_samples() -> Samples:
    """None."""
    return samples_from_rows((), np.zeros((0, FEATURES)))


def samples_from_rows(rows: Iterable[tuple[Any, ...]], features: Floats) -> Samples:
    """Samples of rows in the order of `SAMPLE_COLUMNS`."""
    listed = list(rows)
    values = list(zip(*listed, strict=True)) if listed else [()] * len(SAMPLE_COLUMNS)
    columns = {
        name: np.array(column, dtype)
        for (name, dtype), column in zip(SAMPLE_COLUMNS.items(), values, strict=True)
    }
    return Samples(columns, features)


def joined(samples: Iterable[Samples]) -> Samples:
    """All of them, one after the other."""
    several = [no_samples(), *samples]
    columns = {
        name: np.concatenate([one.columns[name] for one in several]).astype(dtype)
        for name, dtype in SAMPLE_COLUMNS.items()
    }
    return Samples(columns, np.concatenate([one.features for one in several]))
