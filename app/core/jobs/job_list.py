"""All long work of the window: what runs, how far it is, and what came of what ended."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import QObject, QTimer, Signal

_MOST_ENDED = 20
"""Of what ended so many are remembered."""
_BRIEF_S = 2.0
"""Of what takes no longer no word is said when it is done."""
_SHOW_AFTER_S = 1.0
"""What is done by then is never shown; what is shown stays: lines that come and go flicker."""
_LATE = 1.06
"""Timers come up to 5 % too early."""
_TELL_LEFT_AFTER_S = 1.0


class JobState(Enum):
    """Where a job stands."""

    RUNS = auto()
    DONE = auto()
    STOPPED = auto()
    FAILED = auto()


@dataclass(frozen=True, slots=True)
class JobLine:
    """One job as the list shows it.

    Attributes:
        number: of the job, never used again. title: what it does.
        share: done, 0..1; None where that is not known. seconds_left: None likewise.
        cancel: asks it to stop; None where it cannot be. keep: asks it to stop and keeps what
            there is so far; None where that is nothing.
        place: the file or folder that came of it. word: why it failed.
        again: does it once more, where it was stopped and that is possible.
    """

    number: int
    title: str
    state: JobState = JobState.RUNS
    share: float | None = None
    seconds_left: float | None = None
    cancel: Callable[[], object] | None = None
    keep: Callable[[], object] | None = None
    place: Path | None = None
    word: str = ""
    again: Callable[[], object] | None = None

    @property
    def runs(self) -> bool:
        """Whether it is at work."""
        return self.state is JobState.RUNS


class JobList(QObject):
    """Keeps a line for each job; whoever runs it tells how far it is.

    A job stands in the list once it has gone on for a second, and stays there when it has ended.

    Signals: `changed()`, one began, moved or ended. `told(text)`, a word on one that ended, where
    nobody else says what came of it.
    """

    changed = Signal()
    told = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._lines: dict[int, JobLine] = {}
        self._began_s: dict[int, float] = {}
        self._counted_s: dict[int, float] = {}
        self._next = 1

    @property
    def lines(self) -> tuple[JobLine, ...]:
        """Those that run, in the order they began; then those that ended, the last one first."""
        ended = [one for one in self._lines.values() if not one.runs]
        return (*self.running, *reversed(ended))

    @property
    def running(self) -> tuple[JobLine, ...]:
        """Those at work for more than a moment."""
        return tuple(one for one in self._lines.values() if one.runs and self.is_shown(one.number))

    def begin(self, title: str, cancel: Callable[[], object] | None = None) -> int:
        """A job begins; its number, by which it is told of from now on."""
        number, self._next = self._next, self._next + 1
        self._lines[number] = JobLine(number, title, cancel=cancel)
        self._began_s[number] = self._counted_s[number] = time.monotonic()
        QTimer.singleShot(round(1000 * _SHOW_AFTER_S * _LATE), self, self.changed.emit)
        return number

    def restart(self, number: int) -> None:
        """It begins once more under the same line, of something else: time left is counted anew."""
        if number in self._counted_s:
            self._counted_s[number] = time.monotonic()
            self.show(number, None, None)

    def progress(self, number: int, done: int, total: int) -> None:
        """So many of its steps are done."""
        if total <= 0 or number not in self._began_s:
            return
        passed_s = time.monotonic() - self._counted_s[number]
        known = done > 0 and passed_s > _TELL_LEFT_AFTER_S
        self.show(number, done / total, passed_s * (total - done) / done if known else None)

    def show(
        self,
        number: int,
        share: float | None,
        seconds_left: float | None,
        keep: Callable[[], object] | None = None,
    ) -> None:
        """It is so far, whoever worked that out, and stopped now it may `keep` something."""
        line = self._lines.get(number)
        if line is not None and line.runs:
            self._lines[number] = replace(line, share=share, seconds_left=seconds_left, keep=keep)
            self.changed.emit()

    def end(
        self,
        number: int,
        state: JobState,
        place: Path | None = None,
        word: str = "",
        again: Callable[[], object] | None = None,
    ) -> None:
        """It has ended; what ended goes behind all that ended before, and the oldest goes.

        What ended before it was shown, with nothing to open, gets no line. Of what is done again
        and again, as after each edit, only the last time is kept.
        """
        if number not in self._lines:
            return
        wanted = self.is_shown(number) or place is not None or again is not None
        line = self._lines[number]
        self.drop(number)
        if not wanted and state is not JobState.FAILED:
            return
        for other in self._like(line) if place is None else ():
            del self._lines[other]
        self._lines[number] = replace(
            line,
            state=state,
            seconds_left=None,
            cancel=None,
            keep=None,
            place=place,
            word=word,
            again=again,
        )
        ended = [one.number for one in self._lines.values() if not one.runs]
        for old in ended[:-_MOST_ENDED]:
            del self._lines[old]
        self.changed.emit()

    def is_shown(self, number: int) -> bool:
        """Whether it has gone on for so long that it stands in the list."""
        return self._passed_s(number) >= _SHOW_AFTER_S

    def is_brief(self, number: int) -> bool:
        """Whether it has not gone on for longer than somebody notices."""
        return self._passed_s(number) < _BRIEF_S

    def _passed_s(self, number: int) -> float:
        return time.monotonic() - self._began_s.get(number, 0.0)

    def drop(self, number: int) -> None:
        """It is not wanted any more: its line goes without a word."""
        if self._lines.pop(number, None) is not None:
            self._began_s.pop(number, None)
            self._counted_s.pop(number, None)
            self.changed.emit()

    def _like(self, line: JobLine) -> list[int]:
        """Those of the same title that ended with nothing to open."""
        return [
            one.number
            for one in self._lines.values()
            if not one.runs and one.title == line.title and one.place is None
        ]

    def take_over(self, lines: Iterable[JobLine]) -> None:
        """Go on with what ended in another list, the last one first; none of it begins again."""
        for line in reversed([one for one in lines if not one.runs]):
            number, self._next = self._next, self._next + 1
            self._lines[number] = replace(line, number=number, again=None)
        self.changed.emit()

    def forget(self) -> None:
        """Forget what ended."""
        self._lines = {number: one for number, one in self._lines.items() if one.runs}
        self.changed.emit()
