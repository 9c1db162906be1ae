"""What the page of a project shows."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

Sortable = float | str
"""What a column is sorted by; -1 where there is nothing."""


class Mood(Enum):
    """How a row's state is coloured."""

    PLAIN = "plain"
    QUIET = "quiet"
    GOOD = "good"
    BAD = "bad"


@dataclass(frozen=True, slots=True)
class RecordingRow:
    """A recording as the list shows it.

    Attributes:
        name: of it. detail: below the name. mood: of the state.
        cells: texts of the columns after the name. order: what they are sorted by.
        tip: all that is known of it, in lines.
        path: what is opened. recording: where its recording is; None: the session tells.
        image: what its image is kept under; another one where the image may be another.
    """

    name: str
    detail: str
    mood: Mood
    cells: tuple[str, ...]
    order: tuple[Sortable, ...]
    tip: str
    path: Path
    recording: Path | None
    image: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ProjectScene:
    """A project's page.

    Attributes:
        title: the folder's name. place: where it is.
        rows: the recordings. summary: how many, and how far they are, in a line.
        next_text: which is reviewed next and why; "" where none is. next_row: its name.
        reading: share of what is being read, 0 to 1; None: nothing is.
        notes: what to know of the folder. empty: what is said where nothing is listed.
    """

    title: str = ""
    place: str = ""
    rows: tuple[RecordingRow, ...] = ()
    summary: str = ""
    next_text: str = ""
    next_row: str = ""
    reading: float | None = None
    notes: tuple[str, ...] = ()
    empty: str = ""
