"""What a reader is asked, and what it answers; apart from the reading, which takes long to load."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from tracking.project.facts import Facts, RecordingFacts, SessionFacts
from tracking.translation import Message


@dataclass(frozen=True, slots=True)
class Reading:
    """What is to be read.

    Attributes:
        path: of a recording, or of a session.
        of_session: which of the two.
        recording: of a session the one that it is of, for an image and a score; None: not here.
    """

    path: Path
    of_session: bool
    recording: Path | None = None


@dataclass(frozen=True, slots=True)
class ReadFacts:
    """What was read. Attributes: image: a small JPEG image; b"": there is none."""

    facts: Facts
    image: bytes = b""


def unreadable(of_session: bool, why: Message) -> ReadFacts:
    """What is told of a file that could not be read at all."""
    kind = SessionFacts if of_session else RecordingFacts
    return ReadFacts(kind(problem=why))
