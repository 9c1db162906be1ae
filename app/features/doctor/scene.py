"""What the doctor's page shows: frozen values, without Qt."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum, auto

from tracking.arrays import Picture


class State(Enum):
    """What the page is at."""

    WORKING = auto()
    WELL = auto()
    """Nothing was found."""
    FOUND = auto()
    FAILED = auto()
    CANCELLED = auto()


@dataclass(frozen=True, slots=True, eq=False)
class FindingScene:
    """One finding.

    Attributes:
        code: by which it is mended. title: what is wrong. cost: in floor error, short.
        meaning: what the cost means. fix: what to do.
        figures: names and values that show it. alike: what else would look the same; "": nothing.
        picture: (height, width, 3) BGR; None: figures say it all.
        mendable: there is something to press.
    """

    code: str
    title: str
    cost: str
    meaning: str
    fix: str
    figures: tuple[tuple[str, str], ...]
    alike: str
    picture: Picture | None
    mendable: bool


@dataclass(frozen=True, slots=True, eq=False)
class DoctorScene:
    """The whole page.

    Attributes:
        text: what is said above the findings, or instead of them.
        unchecked: checks that could not be made, and why; "": all were made.
        mended: what was mended last and can be undone; "": nothing.
    """

    state: State
    text: str
    findings: tuple[FindingScene, ...] = ()
    unchecked: str = ""
    mended: str = field(default="")
