"""The line of one piece of work in the list of its window, found by whom the work belongs to."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import shiboken6
from PySide6.QtCore import QObject, Qt

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.jobs.job_list import JobList, JobState
from tracking.errors import CancelledError


def job_list_of(owner: QObject | None) -> JobList | None:
    """The list of the window that something belongs to; None where there is no such window."""
    only_own = Qt.FindChildOption.FindDirectChildrenOnly
    while owner is not None:
        found = owner.findChild(JobList, options=only_own)
        if found is not None:
            return found
        owner = owner.parent()
    return None


def cancelled_error() -> CancelledError:
    """What a panel says in place of what the user cancelled, and how it starts again."""
    return CancelledError("Cancelled; the list of jobs starts it again")


class ListedJob:
    """Puts one piece of work into the list, moves it and takes it out; may be begun again.

    Without a list, as in a dialog on its own or for work that is not listed, nothing happens.
    """

    def __init__(
        self, title: str, owner: QObject | None, cancel: Callable[[], object] | None = None
    ) -> None:
        """A line that is not shown yet.

        owner: whose window has the list; None where the work is not listed. cancel: asks the work
        to stop; None where it cannot be.
        """
        self._title, self._owner, self._cancel = title, owner, cancel
        self._jobs: JobList | None = None
        self._number = self._stopped = 0

    def drop_with(self, owner: QObject) -> None:
        """Drop it once an object goes.

        The connection holds this one: a bound method would not, and the garbage collector may run
        in the thread of a job while the window's thread is told.
        """
        owner.destroyed.connect(partial(ListedJob.drop, self))

    def begin(self) -> None:
        """The work begins, or goes on with something newer."""
        if self._number:
            self._with_list(lambda jobs: jobs.restart(self._number))
            return
        self.drop()
        self._jobs = job_list_of(self._owner)
        if self._jobs is not None:
            self._number = self._jobs.begin(self._title, self._cancel)

    def progress(self, done: int, total: int) -> None:
        """So many of its steps are done."""
        self._with_list(lambda jobs: jobs.progress(self._number, done, total))

    def done(self) -> None:
        """It is done; that is said where it took long."""
        self._end(JobState.DONE, tr("Done: {title}", title=self._title))

    def stopped(self, again: Callable[[], object] | None = None) -> None:
        """The user cancelled it; `again` does it once more, as long as it is wanted."""
        number = self._number
        self._end(JobState.STOPPED, tr("Stopped: {title}", title=self._title), again=again)
        self._stopped = number if again is not None else 0

    def failed(self, error: Exception) -> None:
        """It could not be done; whoever asked for it says so, the list only where it took long."""
        number = self._number

        def tell(jobs: JobList) -> None:
            if jobs.is_shown(number):
                jobs.end(number, JobState.FAILED, word=explain(error))
            else:
                jobs.drop(number)

        self._with_list(tell)
        self._number = 0

    def drop(self) -> None:
        """Nobody wants it any more."""
        for number in filter(None, (self._number, self._stopped)):
            self._with_list(partial(_drop, number))
        self._number = self._stopped = 0

    def _with_list(self, tell: Callable[[JobList], object]) -> None:
        """Tell the list, unless its window has gone."""
        if self._jobs is not None and shiboken6.isValid(self._jobs):
            tell(self._jobs)

    def _end(self, state: JobState, said: str, again: Callable[[], object] | None = None) -> None:
        number, self._number = self._number, 0

        def tell(jobs: JobList) -> None:
            if number and not jobs.is_brief(number):
                jobs.told.emit(said)
            jobs.end(number, state, again=again)

        self._with_list(tell)


def _drop(number: int, jobs: JobList) -> None:
    jobs.drop(number)
