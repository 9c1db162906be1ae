"""What became of a recording: plain values that files, pipes and a database hold."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from typing import Any, Self

from tracking.message_data import message_data, message_from
from tracking.translation import N_, Message

_NOTHING = Message()


class State(StrEnum):
    """How it ended."""

    DONE = N_("done")
    FAILED = N_("failed")
    SKIPPED = N_("skipped")


class Cause(StrEnum):
    """Why it is not done.

    A death of the worker and an error of the disk may pass, and are tried again; what the input
    causes is not, as long as that stays the same; nor is a limit, as long as it is not raised.
    """

    NONE = ""
    INPUT = "input"
    BUG = "bug"
    LIMIT = "limit"
    WORKER = "worker"
    DISK = "disk"
    PROTECTED = "protected"

    @property
    def may_pass(self) -> bool:
        """Whether trying once more makes sense."""
        return self in (Cause.WORKER, Cause.DISK)


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a recording.

    Attributes:
        state, cause: see there. why: of what is not done.
        tracked: whether a tracker worked for it, this time.
        fingerprint: digest of the files read and of what was asked of the tracker; "": not known.
        signature: of the files, before the work began; see `signature_of`.
        outside: files it was made from outside of the recording's folder.
        session: digest of the session's bytes; "": none was made.
        session_state: size and times of the session's file, as `file_state`, as the work began;
            once it is in place, of that; (): it is replaced whatever became of it.
        reference: by which the session knows the recording again.
        folder: of the recording, what its manifest's paths are relative to.
        tracker: its name. frames, people: how many there are. fps: frames per second.
        seconds: the work took.
        notes: what the user should be told.
        review_rows: of all rows the share that is expected to be wrong.
        truth: digest of the ground truth that it was scored against; "": there is none.
        score: by the names of `score --json`, without curves; none: not scored.
        page: whether there is a page on the score.
        exports: files by the names of formats, relative to the output folder.
        export_problems: why a format could not be written, by its name.
        corrected: whether somebody corrected the session since.
        trace: where in the program a bug showed.
    """

    state: State
    cause: Cause = Cause.NONE
    why: Message = _NOTHING
    tracked: bool = False
    fingerprint: str = ""
    signature: str = ""
    outside: tuple[str, ...] = ()
    session: str = ""
    session_state: tuple[int, ...] = ()
    reference: str = ""
    folder: str = ""
    tracker: str = ""
    frames: int = 0
    people: int = 0
    fps: float = 0.0
    seconds: float = 0.0
    notes: tuple[Message, ...] = ()
    review_rows: float | None = None
    truth: str = ""
    score: Mapping[str, Any] | None = None
    page: bool = False
    exports: Mapping[str, tuple[str, ...]] | None = None
    export_problems: Mapping[str, Message] | None = None
    corrected: bool = False
    trace: str = ""

    @property
    def is_done(self) -> bool:
        """Whether all that was asked for is there."""
        return self.state is State.DONE

    def as_text(self) -> str:
        """As JSON. Raises ValueError for a number that is none."""
        data = {field.name: getattr(self, field.name) for field in fields(self)}
        data["why"] = message_data(self.why)
        data["notes"] = [message_data(note) for note in self.notes]
        problems = self.export_problems or {}
        data["export_problems"] = {name: message_data(why) for name, why in problems.items()}
        return json.dumps(data, allow_nan=False)

    @classmethod
    def from_text(cls, text: str) -> Self:
        """What `as_text` wrote. Raises ValueError where the text is damaged."""
        try:
            data = json.loads(text)
            values = {field.name: data[field.name] for field in fields(cls)}
            values["state"], values["cause"] = State(values["state"]), Cause(values["cause"])
            values["why"] = _message(values["why"])
            values["notes"] = tuple(map(_message, values["notes"]))
            problems = values["export_problems"] or {}
            values["export_problems"] = {name: _message(why) for name, why in problems.items()}
            values["exports"] = _lists(values["exports"] or {})
            values["outside"] = tuple(map(str, values["outside"]))
            values["session_state"] = tuple(map(int, values["session_state"]))
            return cls(**values)
        except (LookupError, TypeError, AttributeError, RecursionError) as error:
            raise ValueError("no outcome of a recording") from error

    def set_back(self, state: State, cause: Cause, why: Message) -> Outcome:
        """What is left of it where it came to nothing after all: nothing that was made."""
        return Outcome(
            *(state, cause, why, self.tracked),
            signature=self.signature,
            outside=self.outside,
            seconds=self.seconds,
        )

    def failed(self, cause: Cause, why: Message) -> Outcome:
        """The same whose session is in place, but not all that was made of it."""
        return replace(self, state=State.FAILED, cause=cause, why=why, page=False, exports=None)

    def on_top_of(self, known: Outcome) -> Outcome:
        """What was known before, with what this failure tells: it changed no result."""
        return replace(
            known,
            state=self.state,
            cause=self.cause,
            why=self.why,
            tracked=self.tracked,
            signature=self.signature,
            outside=self.outside or known.outside,
            seconds=self.seconds,
            trace=self.trace,
        )


def failure(cause: Cause, why: Message, **known: Any) -> Outcome:
    """The outcome of a recording that failed."""
    return Outcome(State.FAILED, cause, why, **known)


def _message(data: object) -> Message:
    return message_from(data) if data != "" else Message()


def _lists(exports: Mapping[str, Any]) -> dict[str, tuple[str, ...]]:
    return {str(name): tuple(map(str, files)) for name, files in exports.items()}
