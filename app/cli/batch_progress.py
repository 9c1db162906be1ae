"""How far a batch is, on stderr: what each worker does, what failed, and the time that is left."""

from __future__ import annotations

import sys
import time
from collections import Counter
from collections.abc import Iterable
from contextlib import ExitStack
from datetime import timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Self

from app.cli.output import escape_controls, say
from tracking.batch import BatchState, Doing, Listener, Outcome, State
from tracking.translation import Message, count_msg, msg, tr

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_LINE_EVERY_S = 15.0
"""Where there is no terminal."""
_MOST_WORKERS_SHOWN = 16


class BatchProgress(Listener):
    """A bar for the batch and a line for each worker; where there is no terminal, lines.

    Attributes:
        places: folders of the recordings that were done, by what sessions know them by.
        told: names of recordings whose failure was told on stderr.
    """

    def __init__(self, missing: Iterable[State] = ()) -> None:
        """missing: what became of words that meant no recording; they are counted, too."""
        self.places: dict[str, Path] = {}
        self.told: set[str] = set()
        self._missing = Counter(missing)
        self._stack = ExitStack()
        self._bar: Progress | None = None
        self._tasks: dict[str, TaskID] = {}
        self._told_s = time.monotonic()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Take the bar away."""
        self._stack.close()
        self._bar = None

    def began(self, state: BatchState) -> None:
        """See `Listener`."""
        if state.done:
            say(_done_before(state))
        self.tell_known(state)
        if sys.stderr.isatty():
            self._begin_bar(state)

    def tell_known(self, state: BatchState) -> None:
        """Tell what failed before this batch began and is not tried now."""
        if state.failed:
            say(
                count_msg(
                    state.failed,
                    "{n} failed before and is left alone; --retry tries it again",
                    "{n} failed before and are left alone; --retry tries them again",
                )
            )

    def ended(self, name: str, outcome: Outcome) -> None:
        """See `Listener`."""
        if outcome.is_done:
            self.places[outcome.reference] = Path(outcome.folder)
            return
        self.told.add(name)
        self._say(
            msg("{state}: {name}: {why}", state=msg(str(outcome.state)), name=name, why=outcome.why)
        )

    def again(self, name: str, outcome: Outcome) -> None:
        """See `Listener`."""
        self._say(msg("{name}: {why}; it is tried again", name=name, why=outcome.why))

    def moved(self, state: BatchState) -> None:
        """See `Listener`."""
        if self._bar is not None:
            self._draw(state)
        elif time.monotonic() - self._told_s >= _LINE_EVERY_S:
            self._told_s = time.monotonic()
            say(self._line(state))
            for worker in sorted(state.doing)[:_MOST_WORKERS_SHOWN]:
                if state.doing[worker].name:
                    say(msg("  {what}", what=_doing(state.doing[worker])))

    def _line(self, state: BatchState) -> Message:
        """How far the batch is; `total` is what the closing lines count."""
        missing = self._missing
        failed = state.failed + missing[State.FAILED]
        skipped = state.skipped + missing[State.SKIPPED]
        total = state.total + missing.total()
        told = msg(
            "{done} of {total} done, {failed} failed, {skipped} skipped, {waiting} to do",
            done=state.done,
            total=total,
            failed=failed,
            skipped=skipped,
            waiting=total - state.done - failed - skipped,
        )
        if state.seconds_left is None:
            return told
        left = timedelta(seconds=round(state.seconds_left))
        return msg("{told}, {left} left", told=told, left=left)

    def _say(self, text: Message) -> None:
        if self._bar is None:
            say(text)
        else:
            self._bar.console.print(escape_controls(text), markup=False, highlight=False)

    def _begin_bar(self, state: BatchState) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn

        name = TextColumn("{task.description}", markup=False)
        bar = Progress(name, BarColumn(), console=Console(stderr=True), transient=True)
        self._bar = self._stack.enter_context(bar)
        self._tasks[""] = bar.add_task(tr(self._line(state)), total=state.total)

    def _draw(self, state: BatchState) -> None:
        assert self._bar is not None
        ended = state.done + state.failed + state.skipped + self._missing.total()
        self._bar.update(
            self._tasks[""], description=escape_controls(self._line(state)), completed=ended
        )
        for worker in sorted(state.doing)[:_MOST_WORKERS_SHOWN]:
            doing = state.doing[worker]
            if worker not in self._tasks:
                self._tasks[worker] = self._bar.add_task("", total=None)
            self._bar.update(
                self._tasks[worker],
                description=escape_controls(_doing(doing)),
                total=doing.total or None,
                completed=doing.done,
            )


def _done_before(state: BatchState) -> Message:
    return count_msg(
        state.total,
        "{done} of {n} recording is done already",
        "{done} of {n} recordings are done already",
        done=state.done,
    )


def _doing(doing: Doing) -> Message:
    """What a worker does."""
    if not doing.name:
        return msg("worker {worker} waits", worker=doing.worker)
    if not doing.total:
        return msg(
            "worker {worker}: {name}, {stage}",
            worker=doing.worker,
            name=doing.name,
            stage=msg(doing.stage),
        )
    return msg(
        "worker {worker}: {name}, {stage} {done} of {total}",
        worker=doing.worker,
        name=doing.name,
        stage=msg(doing.stage),
        done=doing.done,
        total=doing.total,
    )
