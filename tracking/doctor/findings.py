"""What the doctor says of a recording."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from tracking.arrays import Picture
from tracking.geometry import Ground, StereoCalibration
from tracking.translation import Message


@dataclass(frozen=True, slots=True, eq=False)
class Mend:
    """What a recording's files should say instead; None: as they do.

    Attributes:
        calibration, ground: in their place.
        lag: frames by which the right camera is late.
        swapped: the sources of the cameras change places.
    """

    calibration: StereoCalibration | None = None
    ground: Ground | None = None
    lag: int | None = None
    swapped: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Finding:
    """One thing that is wrong.

    Attributes:
        code: by which it is mended and told apart; never translated.
        title: what is wrong. fix: what to do.
        evidence: figures that show it, named with their units.
        cost_m: error on the floor at 5 m that it causes, in metres; infinite where no place on
            the floor is right.
        alike: codes of other faults that explain the pictures as well as this one.
        picture: (h, w, 3) uint8, BGR, with marks; None where figures say it all.
        mend: None where only a person can put it right.
    """

    code: str
    title: Message
    fix: Message
    evidence: Mapping[str, float | int | str]
    cost_m: float
    alike: tuple[str, ...] = ()
    picture: Picture | None = field(default=None, repr=False)
    mend: Mend | None = field(default=None, repr=False)


@dataclass(frozen=True, slots=True, eq=False)
class Examination:
    """Everything the doctor found, dearest first.

    Attributes:
        checked: codes of the checks that could be made.
        unchecked: why others could not, by code.
    """

    findings: tuple[Finding, ...]
    checked: tuple[str, ...]
    unchecked: Mapping[str, Message]

    @property
    def is_partial(self) -> bool:
        """Whether most checks could not be made, so that nothing found means little."""
        return len(self.unchecked) > len(self.checked)
