"""Samples of the failure detector: features of an instant and whether a part was lost there."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.features import FEATURES
from tracking.tracks.columns import column_types

TEXT = np.dtype(object)
"""Stands for a column of text."""

SAMPLE_COLUMNS = column_types(
    recording=TEXT,  # its name
    track=np.int32,
    frame=np.int32,
    part=np.uint8,  # 0 head, 1 torso, 2 hip-leg
    label=np.uint8,  # 1 on its part, 0 off its part
    author=TEXT,  # who labelled it; "" where nobody knows
    reason=TEXT,  # why it was suggested to them; "" where it was not
    source=TEXT,  # one of `SAMPLE_SOURCES`
)
SAMPLE_SOURCES = ("label", "correction", "truth")
"""A rectangle somebody judged, one that somebody put right, one judged by rendered truth."""


@dataclass(frozen=True, slots=True)
class Besides:
    """A column that not every source of samples has.

    Attributes:
        dtype: of it. unknown: stands where the source does not say.
    """

    dtype: np.dtype[Any]
    unknown: float


BESIDES: Mapping[str, Besides] = MappingProxyType(
    {
        "person": Besides(np.dtype(np.int32), 0),  # see `Samples.people`
        "time_s": Besides(np.dtype(np.float64), math.nan),  # since the recording began
        "session": Besides(np.dtype(np.int32), 0),  # whose tracks they are, of those told apart
    }
)
NOT_TOLD_APART = -1
"""As a person: may be anybody of the recording."""

_USUAL_FPS = 20.0
"""Of samples that do not say when they were: close enough to tell a second from a moment."""


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Samples, a row each; n rows.

    Attributes:
        columns: `SAMPLE_COLUMNS` and `BESIDES`, (n,) each; of the latter those given.
        features: (n, 60), see `FEATURE_NAMES`; those of the paper finite, evidence NaN where it
            is not known. Given as (n, 36) where no evidence is.
    """

    columns: Mapping[str, NDArray[Any]]
    features: Floats

    def __post_init__(self) -> None:
        """Fill in what the source does not say."""
        rows = len(self.features)
        lacking = FEATURES - self.features.shape[-1] if rows else 0
        if lacking:
            evidence = np.full((rows, lacking), np.nan)
            object.__setattr__(self, "features", np.concatenate((self.features, evidence), axis=1))
        unknown = {name: np.full(rows, one.unknown, one.dtype) for name, one in BESIDES.items()}
        object.__setattr__(self, "columns", {**unknown, **self.columns})

    def __len__(self) -> int:
        """How many there are."""
        return len(self.features)

    def __getitem__(self, rows: NDArray[Any] | slice) -> Samples:
        """Some of them, by mask, index or slice."""
        columns = {name: column[rows] for name, column in self.columns.items()}
        return Samples(columns, self.features[rows])

    @property
    def has_evidence(self) -> NDArray[np.bool_]:
        """(n,) of which all of the evidence is known."""
        return np.asarray(np.isfinite(self.features).all(axis=1))

    def counts(self) -> NDArray[np.int64]:
        """(3, 2) how many samples of each part are off it and on it."""
        place = self.columns["part"].astype(np.int64) * 2 + self.columns["label"]
        return np.bincount(place, minlength=6).reshape(3, 2)

    def people(self) -> NDArray[np.int64]:
        """(n,) a number for everybody, from 0 on: what may be of one person has the same.

        A person is who truth says it is (`person` above 0), else the track (0), of a recording;
        where not even tracks tell people apart (`NOT_TOLD_APART`), all of the recording are one.
        """
        person = self.columns["person"].astype(np.int64)
        track = self.columns["track"].astype(np.int64)
        kind = np.sign(person)
        return _numbered(self.columns["recording"], kind, np.where(kind == 0, track, person))

    def instants(self) -> NDArray[np.int64]:
        """(n,) a number for each frame of a track, from 0 on: what was seen of somebody at once."""
        own = (self.columns[name].astype(np.int64) for name in ("session", "track", "frame"))
        return _numbered(self.columns["recording"], *own)

    def times_s(self) -> Floats:
        """(n,) when each was; by the frame at a usual rate where that is not known."""
        time_s = self.columns["time_s"]
        return np.where(np.isnan(time_s), self.columns["frame"] / _USUAL_FPS, time_s)

    def with_columns(self, **columns: NDArray[Any]) -> Samples:
        """The same with other columns (n,)."""
        return Samples({**self.columns, **columns}, self.features)


def _numbered(text: NDArray[Any], *numbers: NDArray[np.int64]) -> NDArray[np.int64]:
    """(n,) which of the different rows of some columns (n,) each row is, from 0 on, in order."""
    if not len(text):
        return np.zeros(0, np.int64)
    names = np.unique(text.astype(str), return_inverse=True)[1].reshape(-1)
    rows = np.column_stack((names, *numbers))
    return np.unique(rows, axis=0, return_inverse=True)[1].reshape(-1).astype(np.int64)


def no_samples() -> Samples:
    """None."""
    return samples_from_rows((), np.zeros((0, FEATURES)))


def samples_from_rows(
    rows: Iterable[tuple[Any, ...]], features: Floats, **besides: NDArray[Any]
) -> Samples:
    """Samples of rows in the order of `SAMPLE_COLUMNS`, and of the columns `BESIDES` known."""
    listed = list(rows)
    values = list(zip(*listed, strict=True)) if listed else [()] * len(SAMPLE_COLUMNS)
    columns = {
        name: np.array(column, dtype)
        for (name, dtype), column in zip(SAMPLE_COLUMNS.items(), values, strict=True)
    }
    return Samples({**columns, **besides}, features)


_DTYPES = {**SAMPLE_COLUMNS, **{name: one.dtype for name, one in BESIDES.items()}}


def joined(samples: Iterable[Samples]) -> Samples:
    """All of them, one after the other."""
    several = [no_samples(), *samples]
    columns = {
        name: np.concatenate([one.columns[name] for one in several]).astype(dtype)
        for name, dtype in _DTYPES.items()
    }
    return Samples(columns, np.concatenate([one.features for one in several]))
