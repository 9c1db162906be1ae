"""Ground truth and errors as pictures, floor and timeline show them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import Colour, LegendEntry, Points
from app.core.scenes.error_events import ErrorEvents
from app.core.scenes.okabe_ito import GREEN, PURPLE
from tracking.scoring import ErrorKind

# Apart for all eyes; each kind has a shape of its own, too. Misses and false alarms are drawn over
# people: no track has a colour near theirs.
ERROR_COLOURS: Final[dict[ErrorKind, Colour]] = {
    ErrorKind.SWITCH: PURPLE,
    ErrorKind.FRAGMENTATION: GREEN,
    ErrorKind.MISS: (255, 50, 0),
    ErrorKind.FALSE_ALARM: (225, 0, 225),
}
"""In the order in which they are listed."""

TRUTH_COLOUR: Final[Colour] = (255, 255, 255)


@dataclass(frozen=True, slots=True, eq=False)
class ErrorLane:
    """One kind of error over the recording.

    Attributes:
        kind: see `ErrorKind`. name: e.g. "Misses". count: how many, frame by frame.
        density: (frames,) how many there are at once in each frame.
        events: the stretches.
    """

    kind: ErrorKind
    name: str
    count: int
    density: NDArray[np.uint16]
    events: ErrorEvents


@dataclass(frozen=True, slots=True, eq=False)
class ErrorLanes:
    """The lanes of errors below those of people; the very same while the errors stay.

    Attributes:
        fps: of the recording. message: said where there are none.
    """

    lanes: tuple[ErrorLane, ...]
    fps: float
    message: str = ""


@dataclass(frozen=True, slots=True)
class TruthMark:
    """Somebody of the truth, or a false alarm, in a picture.

    Attributes:
        box: left, top, width, height in pixels of that camera. label: "" for none.
        wrong: what goes wrong there in this frame; None: nothing.
    """

    box: tuple[float, float, float, float]
    label: str
    wrong: ErrorKind | None = None


@dataclass(frozen=True, slots=True, eq=False)
class TruthPlace:
    """Somebody of the truth on the floor: (n, 2) metres, oldest first; else as `TruthMark`."""

    trail: Points
    label: str
    wrong: ErrorKind | None = None


class ErrorsOf(Enum):
    """Which of two compared versions of the tracks was scored: its people are drawn so."""

    SOLID = "solid"
    DASHED = "dashed"
    NEITHER = "neither"


@dataclass(frozen=True, slots=True)
class PicturedTruth:
    """The truth over a picture.

    Attributes:
        legend: what the marks mean. floor_tells: it stands on the floor as well.
        errors_of: whose errors are marked; in a divided picture these stand on its side alone.
    """

    people: tuple[TruthMark, ...] = ()
    alarms: tuple[TruthMark, ...] = ()
    legend: tuple[LegendEntry, ...] = ()
    floor_tells: bool = True
    errors_of: ErrorsOf = ErrorsOf.SOLID

    @property
    def without_errors(self) -> PicturedTruth:
        """Where people really are, alone."""
        people = tuple(replace(one, wrong=None) for one in self.people)
        return replace(self, people=people, alarms=())


@dataclass(frozen=True, slots=True, eq=False)
class FlooredTruth:
    """The truth on the floor.

    Attributes:
        alarms: where tracks are that are nobody. legend: what the marks mean.
        bounds: of the floor the truth is on in all frames: left, bottom, right, top in metres.
    """

    people: tuple[TruthPlace, ...] = ()
    alarms: tuple[TruthPlace, ...] = ()
    legend: tuple[LegendEntry, ...] = ()
    bounds: tuple[float, float, float, float] | None = None


NO_TRUTH: Final = (PicturedTruth(), FlooredTruth())
"""What is drawn where no truth is shown."""
