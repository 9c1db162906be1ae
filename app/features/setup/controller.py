"""What was entered in a set-up, and the work on it beside the window's thread."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.core.error_messages import explain, explain_in_sentence
from app.core.i18n import tr
from app.core.jobs.jobs import Job
from app.core.jobs.latest_job import LatestJob
from app.features.setup import cameras_presenter, presenter, trial
from app.features.setup.drafts import Drafts
from app.features.setup.presenter import SetupHistory
from app.features.setup.scene import CameraImages, Checked, SetupScene, SetupState, Step
from tracking.errors import TrackwrightError
from tracking.progress import Progress
from tracking.setup import SetupPlan

_MIDDLE = 0.5


class SetupEditor(QObject):
    """Changes what was entered, undoes it, keeps it on disk, and opens it as a trial.

    Nothing that reads files is done on the window's thread. What was found for a state that does
    not count any more is left out.

    Signals:
        drawn(): the scene is another one. worked(text, share): long work goes on, share 0 to 1,
        below 0 where that is not known; "" where none does.
    """

    drawn = Signal()
    worked = Signal(str, float)

    def __init__(self, state: SetupState, drafts: Drafts, parent: QObject) -> None:
        super().__init__(parent)
        self._drafts = drafts
        self._history = SetupHistory(state)
        self._share = _MIDDLE
        self._job: Job | None = None
        self.resumed = False
        self.scene = SetupScene(state)
        self._checks = LatestJob(
            tr("Checking the set-up"),
            lambda plan: lambda _: trial.check(plan),
            self,
            cancellable=False,
        )
        self._checks.found.connect(self._take_check)
        self._checks.failed.connect(self._take_no_check)
        self._reads = LatestJob("set-up images", _read, self, listed=False)
        self._reads.found.connect(self._take_images)
        self._reads.failed.connect(self._take_no_images)
        self._saves = LatestJob("set-up draft", self._save, self, listed=False)
        self._saves.failed.connect(self._tell_unsaved)
        self._look_again()

    # what was entered

    @property
    def state(self) -> SetupState:
        """What counts now."""
        return self._history.state

    @property
    def may_undo(self) -> bool:
        """Whether there is something to undo."""
        return self._history.may_undo and not self.scene.busy

    @property
    def may_redo(self) -> bool:
        """Whether there is something to redo."""
        return self._history.may_redo and not self.scene.busy

    @property
    def busy(self) -> bool:
        """Whether anything is at work."""
        return self._job is not None or any(
            job.busy for job in (self._checks, self._reads, self._saves)
        )

    def change(self, state: SetupState) -> None:
        """Take what a person entered."""
        if self._history.change(state):
            self._show()

    def try_change(self, step: Step, change: Callable[[], SetupState]) -> None:
        """The same where the change may be refused: why is told beside the step."""
        try:
            state = change()
        except Exception as error:
            self.tell(step, explain_in_sentence(error))
            return
        self.tell(step, "")
        self.change(state)

    def undo(self) -> None:
        """Go back by a change."""
        if self.may_undo:
            self._history.undo()
            self._show()

    def redo(self) -> None:
        """Take back an undo."""
        if self.may_redo:
            self._history.redo()
            self._show()

    def tell(self, step: Step, problem: str) -> None:
        """Say beside a step what failed; "": nothing any more."""
        if self.scene.problems.get(step, "") != problem:
            self._draw(problems={**self.scene.problems, step: problem})

    def take_row_error(self, files: tuple[Path, ...], px: float) -> None:
        """Note how far rows are apart with a calibration, as its rectified pair shows."""
        if self.scene.row_error != (files, px):
            self._draw(row_error=(files, px))

    def show_at(self, share: float) -> None:
        """Show another instant of the footage, 0 to 1."""
        self._share = share
        self._ask_images()

    @property
    def share(self) -> float:
        """The instant that is shown, 0 to 1."""
        return self._share

    # long work

    def take_paths(self, paths: Sequence[Path]) -> None:
        """Look at these files, or go on with a set-up of them that was interrupted."""

        def work(progress: Progress) -> tuple[SetupState, bool]:
            plan = cameras_presenter.plan_of_paths(paths)
            draft = self._drafts.find(plan)
            if draft is not None:
                return draft, True
            return cameras_presenter.look(plan, progress), False

        def done(found: tuple[SetupState, bool]) -> None:
            state, self.resumed = found
            by_hand = state.by_hand | {"files"}
            self.change(replace(state, by_hand=by_hand))

        self.run(Step.CAMERAS, tr("Looking at the cameras"), work, done)

    def begin_anew(self) -> None:
        """Forget what was entered for these cameras, and look at them again."""
        plan = self.state.plan
        if plan is None:
            return
        self._drafts.forget(plan)
        self.resumed = False
        files = [plan.at] if plan.at is not None else [plan.left, plan.right]
        # Of a bag or a tar both cameras are one file.
        self.take_paths([*dict.fromkeys(file for file in files if file is not None)])

    def take_calibration(self, made: Any) -> None:
        """Keep a calibration that was made (`MadeCalibration`) until it is written; use it."""
        plan = self.state.plan
        if plan is None:
            return

        def done(file: Path) -> None:
            from app.features.setup.calibration_presenter import with_made

            self.scene = replace(self.scene, boards=made.boards)
            self.change(with_made(self.state, file, made.told))
            self._draw(boards=made.boards)

        keep = partial(self._drafts.keep_calibration, plan, made.calibration)
        self.run(Step.CALIBRATION, tr("Keeping the calibration"), lambda _: keep(), done)

    def run(
        self,
        step: Step,
        title: str,
        work: Callable[[Progress], Any],
        done: Callable[[Any], None],
    ) -> None:
        """Do long work of a step beside the window; what fails is told beside the step."""
        if self._job is not None:
            return
        self._job = job = Job(title, work, self, cancellable=step is not Step.WRITE)
        job.progressed.connect(lambda at, all_: self.worked.emit(title, _share(at, all_)))
        job.done.connect(lambda result: self._end(lambda: done(result)))
        job.failed.connect(
            lambda error: self._end(lambda: self.tell(step, explain_in_sentence(error)))
        )
        job.cancelled.connect(lambda: self._end(lambda: self.tell(step, tr("Cancelled."))))
        self.tell(step, "")
        job.start()
        self.worked.emit(title, -1.0)
        self._draw(doing=title)

    def cancel(self) -> None:
        """Ask the long work to stop."""
        if self._job is not None:
            self._job.cancel()

    def stop(self) -> None:
        """End everything, as the window closes; what was entered is on disk but for a moment's."""
        for job in (self._checks, self._reads):
            job.stop()
        if self._saves.busy:
            with contextlib.suppress(TrackwrightError, OSError):  # as full a disk as before
                self._drafts.save(self.state)
        with contextlib.suppress(OSError):  # they lie there until the next time
            self._drafts.close()
        if self._job is not None:
            work, self._job = self._job, None
            work.leave_untold()

    def forget_draft(self) -> None:
        """It was written."""
        self._saves.stop()
        if self.state.plan is not None:
            self._drafts.forget(self.state.plan, for_good=True)

    def _end(self, then: Callable[[], None]) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        self.worked.emit("", 1.0)
        self._draw(doing="")
        then()

    # what follows from a change

    def _show(self) -> None:
        told = presenter.still_told(self.scene.problems, self.scene.state, self.state)
        self._draw(state=self.state, problems=told)
        self._look_again()
        if self.state.plan is not None:
            self._saves.ask(self.state)

    def _look_again(self) -> None:
        if self.state.plan is not None:
            self._checks.ask(self.state.plan)
            self._ask_images()

    def _ask_images(self) -> None:
        plan = self.state.plan
        if plan is not None:
            self._reads.ask((presenter.bare(replace(plan, name="")), self._share))

    def _take_check(self, checked: Checked) -> None:
        if checked.plan == self.state.plan:
            self._draw(checked=checked)

    def _take_no_check(self, plan: SetupPlan, error: Exception) -> None:
        """Say why it cannot be written: nothing else would."""
        self._take_check(Checked(plan, problem=explain_in_sentence(error), step=Step.WRITE))

    def _take_images(self, images: CameraImages) -> None:
        self._draw(images=images)

    def _take_no_images(self, _subject: object, _error: object) -> None:
        self._draw(images=None)  # why is told by the check

    def _save(self, state: SetupState) -> Callable[[Progress], Any]:
        return lambda _: self._drafts.save(state)

    def _tell_unsaved(self, _subject: object, error: Exception) -> None:
        self.tell(Step.WRITE, tr("What was entered is not kept: {why}", why=explain(error)))

    def _draw(self, **changes: Any) -> None:
        self.scene = replace(self.scene, **changes)
        self.drawn.emit()


def _share(done: int, total: int) -> float:
    """Below 0 once all steps are done: what comes then has none."""
    return done / total if 0 <= done < total else -1.0


def _read(subject: tuple[SetupPlan, float]) -> Callable[[Progress], CameraImages]:
    return lambda _: presenter.read_images(*subject)
