"""Comparing a run with the corrected tracks, or with another run, in all views."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from PySide6.QtCore import QObject, Signal

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.i18n import tr
from app.core.jobs.jobs import Job
from app.core.playback.playback import Playback
from app.core.projection.other_people import OtherPeople
from app.features.comparison.difference_search import ComparisonResult
from app.features.comparison.differences_scene import DifferenceOrder
from app.features.comparison.panel import DifferencesPanel
from app.features.comparison.presenter import Comparison
from tracking.editing import Change, Difference
from tracking.errors import TrackwrightError
from tracking.session import Session

_BEFORE_S = 0.5


class ComparisonController(Controller):
    """The comparison that is shown, and what is taken from it.

    `changed`: another one or none is shown. Signals: `edited()`, the tracks or what is selected are
    others than before; `scene_changed(scene)`, for the panel, None for no comparison;
    `concerned(concern)`, people are looked at, None for nobody any more.
    """

    edited = Signal()
    concerned = Signal(object)
    scene_changed = Signal(object)

    def __init__(
        self,
        document: Document,
        playback: Playback,
        panel: DifferencesPanel,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._playback = document, playback
        self._panel = panel
        self._comparison: Comparison | None = None
        self._dashed: OtherPeople | None = None
        self._searched: tuple[object, ...] = ()
        self._job: Job | None = None
        self._share: float | None = None  # of the search, done by now
        self._taken = False  # something, since the last search
        self._told = ""  # of what was taken last
        self._connect()

    def _connect(self) -> None:
        panel = self._panel
        panel.chosen.connect(self._choose)
        # The panel outlives this object: a function of its own would be kept by it for ever.
        panel.ticked.connect(self._tick)
        panel.all_ticked.connect(self._tick_all)
        panel.person_chosen.connect(self._narrow)
        panel.order_chosen.connect(self._sort)
        panel.taken.connect(self._take)
        panel.dropped.connect(self.drop)
        panel.closed.connect(self.close)
        panel.cancelled.connect(self.cancel)

    @property
    def shown(self) -> bool:
        """Whether a comparison is shown."""
        return self._comparison is not None

    @property
    def dashed(self) -> OtherPeople | None:
        """The run's people, to be drawn dashed in all views; None where none is compared."""
        return self._dashed

    @property
    def versions(self) -> tuple[str, str]:
        """What is drawn solid and what dashed, by name; "" where nothing is compared."""
        return self._comparison.versions if self._comparison is not None else ("", "")

    def correct(self, number: int) -> None:
        """Have a run's tracks be the ones to correct: at once, or by taking them over the edits.

        What nobody has edited begins anew as the run. Where people have edited, or the run is of
        fewer frames, it is compared, with everything ticked that it says otherwise: one edit takes
        it, and what people corrected, or is outside of its frames, stays.
        """
        session = self._document.session
        if session is None:
            return
        try:
            self._document.refuse_at_work()
            why_compared = _why_compared(session, number)
            if not why_compared:
                session.adopt_run(number)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        if why_compared:
            self.open(number, everything=True)
            self.said.emit(why_compared)
            return
        self._document.take_session(session)
        self.said.emit(tr("Run {n} is the one being corrected now", n=number))
        self.edited.emit()
        self.changed.emit()

    def open(self, run: int, base: int | None = None, *, everything: bool = False) -> None:
        """Compare a run with the corrected tracks, or with another run.

        `everything` that can be taken is ticked at first.
        """
        session = self._document.session
        if session is None:
            return
        self.close()
        self._document.correcting.leave()
        self._searched, self._taken = (), False
        fps = self._document.recording.fps
        self._comparison = Comparison(
            session, run, base, fps, everything=everything, colour_of=self._document.colour_of
        )
        self._document.comparison = self._comparison
        self.refresh()
        self.changed.emit()

    def close(self) -> None:
        """Show the panels again; nothing is changed."""
        self._stop()
        if self._comparison is not None:
            self._comparison = self._dashed = self._document.comparison = None
            self.scene_changed.emit(None)
            self.concerned.emit(None)
            self.edited.emit()
            self.changed.emit()

    def end(self) -> None:
        """Close, and wait for what still runs."""
        self.close()
        for job in self.findChildren(Job):
            job.wait()

    def cancel(self) -> None:
        """Compare no further; what was found before stays shown."""
        if self._job is not None:
            self._job.cancel()

    def refresh(self) -> None:
        """Follow the document: look again where its tracks or its labels are others."""
        session = self._document.session
        if self._comparison is None:
            return
        if session is None or self._document.is_live:
            self.close()
            return
        now = (session, session.tracks.revision, session.labels.reviewed)
        if now != self._searched:
            self._searched = now
            self._search(self._comparison)
        self._show()

    def walk(self, step: int) -> None:
        """N (1) or P (-1) while a comparison is shown."""
        if self._comparison is not None:
            self._look_at(self._comparison.walk(step))

    def drop(self) -> None:
        """Forget the run that is compared; nothing of it was taken, or what was stays."""
        comparison = self._comparison
        if comparison is not None:
            self.close()
            self.drop_run(comparison.run)

    def drop_run(self, number: int) -> None:
        """Forget the last run."""
        session = self._document.session
        if session is None:
            return
        try:
            session.drop_run(number)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        self.said.emit(tr("Deleted: run {n}", n=number))
        self.changed.emit()

    # finding

    def _search(self, comparison: Comparison) -> None:
        """Find what differs, off the GUI thread; the newest search wins."""
        self._stop()
        job = Job(tr("Looking for differences"), comparison.search(), self)
        job.progressed.connect(self._progress)
        job.done.connect(lambda found: self._found(comparison, found))
        job.failed.connect(self._fail)
        job.cancelled.connect(self._cancelled)
        self._job, self._share = job, None
        job.start()

    def _progress(self, done: int, total: int) -> None:
        self._share = done / total if total else None
        self._show()

    def _found(self, comparison: Comparison, found: ComparisonResult) -> None:
        self._forget_job()
        first, taken = comparison.current is None, self._taken
        self._taken = False
        comparison.take(found)
        if taken and not comparison.offers:
            self._end_taken(comparison)
            return
        self._dashed = OtherPeople(self._document.recording, found.dashed, self._document.colour_of)
        if first:
            self._look_at(comparison.walk(1))
        else:
            self.edited.emit()

    def _end_taken(self, comparison: Comparison) -> None:
        """Nothing of the run is left to take: the panels come back by themselves."""
        self.close()
        self.said.emit(
            tr("{done}; nothing is left to take from run {n}", done=self._told, n=comparison.run)
        )

    def _fail(self, error: Exception) -> None:
        self._forget_job()
        self.close()
        self.failed.emit(error)

    def _cancelled(self) -> None:
        self._forget_job()
        self.said.emit(tr("Stopped: comparing"))
        if self._dashed is None:
            self.close()
        else:
            self._show()

    def _stop(self) -> None:
        """Let a search go that nobody waits for: it ends at its next step, and is then deleted."""
        if self._job is not None:
            job, self._job = self._job, None
            job.leave_untold()

    def _forget_job(self) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None

    # looking and taking

    def _choose(self, number: int) -> None:
        if self._comparison is not None:
            self._look_at(self._comparison.choose(number))

    def _look_at(self, one: Difference | None) -> None:
        """Go to just before it; all views show both versions."""
        if one is not None and self._comparison is not None:
            before = round(_BEFORE_S * self._document.recording.fps)
            self._playback.pause()
            self.concerned.emit(self._comparison.concern_of(one, before))
            self._playback.go(self._comparison.first_shown(one, before))
            self._document.selection.choose(
                one.track if one.track in self._document.tracks.ids else 0
            )
        self.edited.emit()

    def _tick(self, number: int, on: bool) -> None:
        self._with(lambda one: one.tick([number], on))

    def _tick_all(self, on: bool) -> None:
        self._with(lambda one: one.tick_listed(on))

    def _narrow(self, track: int) -> None:
        self._with(lambda one: one.narrow(track))

    def _sort(self, order: str) -> None:
        self._with(lambda one: one.sort(DifferenceOrder(order)))

    def _with(self, step: Callable[[Comparison], object]) -> None:
        if self._comparison is not None:
            step(self._comparison)
            self._show()

    def _take(self, side: int) -> None:
        """Take what is ticked, from the dashed version (1) or the solid one (0)."""
        comparison = self._comparison
        if comparison is None:
            return
        try:
            if comparison.base is None:
                self._do([comparison.plan])
            else:
                number = comparison.run if side else comparison.base
                self._do(comparison.plans_from(number))
        except TrackwrightError as error:
            self.failed.emit(error)
        self.edited.emit()

    def _do(self, plans: Iterable[Callable[[], Change]]) -> None:
        for plan in plans:
            change = plan()
            self._document.apply(change)
            self._taken = True
            self._told = tr("Done: {what}", what=change.text)
            self.said.emit(self._told)

    def _show(self) -> None:
        if self._comparison is not None:
            doing = tr("Comparing...") if self._job is not None else ""
            self.scene_changed.emit(self._comparison.scene(doing, self._share))


def _why_compared(session: Session, number: int) -> str:
    """Why a run is taken by comparing it, in words; "" where tracks can begin anew as the run."""
    if len(session.history):
        return tr(
            "You have edited already: take the ticked differences, as one edit that can be undone"
        )
    if not session.covers_corrected(session.runs[number]):
        return tr(
            "The run has fewer frames: take the ticked differences, as one edit that can be undone"
        )
    return ""
