"""Two versions of the tracks that are shown together, as far as one frame needs them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import PreviewTrail
from app.core.tracks.made_by import MadeBy
from app.core.tracks.track_reader import TrackReader
from tracking.tracks import Columns

PointsOf = Callable[[Columns], NDArray[np.float64]]
"""Gives the points (n, 2) of rows, on the floor or in a picture."""


class ComparedPair(Protocol):
    """Whom a difference is about; `other` 0: nobody else."""

    @property
    def track(self) -> int:
        """In the version that is drawn solid."""

    @property
    def other(self) -> int:
        """In the other one."""


class TwoVersions(Protocol):
    """A version of the tracks drawn solid, and another one drawn dashed."""

    @property
    def base(self) -> int | None:
        """The run that is drawn solid; None: the corrected tracks are."""

    @property
    def run(self) -> int:
        """The run that is drawn dashed."""

    @property
    def solid(self) -> TrackReader | None:
        """The version that is drawn solid; None where these are the corrected tracks."""

    @property
    def base_run(self) -> MadeBy | None:
        """What made the solid version; None: no run."""

    @property
    def current(self) -> ComparedPair | None:
        """The difference that is looked at."""

    def trails(self, frame: int, points_of: PointsOf) -> tuple[PreviewTrail, ...]:
        """The trails of its people around a frame, in both versions."""
