"""What a project knows of a recording and of a session, as plain values."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Self

from tracking.message_data import message_data, message_from
from tracking.review import ErrorsLeft
from tracking.translation import Message

NO_MESSAGE = Message()
_MOST_AUTHORS = 20


@dataclass(frozen=True, slots=True)
class Facts:
    """What is known of either.

    Attributes:
        name: of the recording. frames: how many there are. fps: frames per second; 0: not known.
        footage: what the images are known by, as in `RecordingReference`; "": not known.
        problem: why nothing else is known; empty: it could be read.
    """

    name: str = ""
    frames: int = 0
    fps: float = 0.0
    footage: str = ""
    problem: Message = NO_MESSAGE

    @property
    def length_s(self) -> float | None:
        """The length of the footage; None: not known."""
        return self.frames / self.fps if self.fps > 0 else None

    def as_text(self) -> str:
        """As JSON."""
        data = {each.name: getattr(self, each.name) for each in fields(self)}
        for name, value in data.items():
            if isinstance(value, Message):
                data[name] = message_data(value) if value else ""
        return json.dumps(data)

    @classmethod
    def from_text(cls, text: str) -> Self:
        """What `as_text` gave. Raises ValueError where it is nothing like it."""
        data = json.loads(text)
        if not isinstance(data, Mapping):
            raise ValueError("no facts")
        blank = cls()
        known = [each.name for each in fields(cls)]
        values = {name: _value(name, data[name]) for name in known if name in data}
        for name, value in values.items():
            if not _is_like(value, getattr(blank, name)):
                raise ValueError("a fact of another kind")
        return cls(**values)


@dataclass(frozen=True, slots=True)
class RecordingFacts(Facts):
    """What a project knows of a recording.

    Attributes:
        cameras: how many. has_truth: whether there is ground truth beside it.
        is_clip: it was exported to show a recording, and is none.
    """

    cameras: int = 0
    has_truth: bool = False
    is_clip: bool = False


@dataclass(frozen=True, slots=True)
class SessionFacts(Facts):
    """What a project knows of a session.

    Attributes:
        place: the recording's folder, seen from the session's, as the session says.
        tracker: whose result the tracks began as; "": nobody's.
        people: how many tracks. rows: person-frames.
        frames_done: frames that were tracked, or have rows.
        reviewed_rows, decided, minutes_left: see `tracking.review.ReviewState`; of labels the share
            of rows in reviewed ranges alone.
        items_left: review items that are neither decided nor in reviewed ranges.
        errors_left, errors_low, errors_high, errors_at_items: see `tracking.review.ErrorsLeft`.
        hand_made: no tracker made the tracks, so that no item was looked for.
        edits: those in force. authors: of these, the latest last. part_labels: of body parts.
        idf1, mota: against the ground truth beside the recording; None: not scored.
        not_scored: why not, where there is ground truth.
    """

    place: str = ""
    tracker: str = ""
    people: int = 0
    rows: int = 0
    frames_done: int = 0
    reviewed_rows: float = 0.0
    decided: int = 0
    items_left: int = 0
    errors_left: float = 0.0
    errors_low: int = 0
    errors_high: int = 0
    errors_at_items: float = 0.0
    minutes_left: float = 0.0
    hand_made: bool = False
    edits: int = 0
    authors: tuple[str, ...] = ()
    part_labels: int = 0
    idf1: float | None = None
    mota: float | None = None
    not_scored: Message = NO_MESSAGE

    @property
    def decided_share(self) -> float | None:
        """The share of the review items that is decided, 0 to 1; None where there are none."""
        items = self.decided + self.items_left
        return self.decided / items if items else None

    @property
    def errors(self) -> ErrorsLeft | None:
        """Identity errors expected to be left; None where nothing was looked for."""
        if self.hand_made or not self.rows:
            return None
        return ErrorsLeft(self.errors_left, self.errors_low, self.errors_high, self.errors_at_items)


_MESSAGES = ("problem", "not_scored")


def _value(name: str, value: Any) -> Any:
    if name in _MESSAGES:
        return message_from(value) if value else Message()
    if isinstance(value, list):
        return tuple(str(each) for each in value[-_MOST_AUTHORS:])
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError("a number that is none")
    return value


def _is_like(value: object, blank: object) -> bool:
    """Whether a value is of the kind that a field holds."""
    if blank is None:
        return value is None or isinstance(value, (int, float))
    if isinstance(blank, bool) or isinstance(value, bool):
        return isinstance(blank, bool) and isinstance(value, bool)
    if isinstance(blank, float):
        return isinstance(value, (int, float))
    return isinstance(value, type(blank))
