"""Counting in the open recording: counters at lines and regions, the panel, the flow map."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial

from PySide6.QtCore import Qt

from app.core.document.track_sources import SHOWN, capture_rows
from app.core.feature import FeatureContext, FeatureController, FloorMarker, Marker, ShownFrame
from app.core.i18n import count_text, tr
from app.core.jobs.latest_job import LatestJob
from app.core.scenes import Side
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.labels import CountText, with_texts
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.counting.panel import CountingPanel
from app.features.counting.presenter import CountingPresenter
from app.features.counting.subject import CountResult, CountSubject, Length, count_subject
from tracking.counting import Counts
from tracking.progress import Progress

Work = Callable[[Progress], CountResult]


class CountController(FeatureController):
    """Counts in the background what is asked for, and shows it.

    `marked`: there are other counts.
    """

    def __init__(
        self,
        context: FeatureContext,
        panel: CountingPanel,
    ) -> None:
        super().__init__(context.parent)
        self._document, self._panel = context.document, panel
        self._floor, self._bounds = context.surfaces.floor, context.floor_bounds
        self.presenter = CountingPresenter(context.document)
        self._search = LatestJob(tr("Counting"), self._prepare, self)
        self._search.found.connect(self._take)
        self._search.failed.connect(self._refuse)
        self._search.cancelled.connect(self._refuse)
        self._search.changed.connect(self.marked, Qt.ConnectionType.QueuedConnection)
        panel.frame_sought.connect(context.playback.go)
        panel.picked.connect(self._pick)
        panel.track_source_chosen.connect(self._choose_track_source)
        panel.step_chosen.connect(self._choose_step)
        panel.jitter_chosen.connect(self._choose_jitter)
        panel.jitter_px_chosen.connect(self._choose_jitter_px)
        panel.copied.connect(self._tell_copied)

    def close(self) -> None:
        """End the thread; leave nothing on the views, which outlive the document."""
        self._search.stop()
        self._panel.show_scene(None)
        self._floor.show_flow(None)

    @property
    def counts(self) -> Counts | None:
        """What was counted last; None while nothing was."""
        counted = self.presenter.counted
        return counted.counts if counted is not None else None

    def work(self) -> Work | None:
        """Counts the tracks of now anew, on any thread; None where nothing is drawn."""
        subject = self.presenter.current_subject(mapped=False)
        return None if subject.is_empty else self._prepare(subject)

    def draw_frame(self, shown: ShownFrame) -> None:
        """Show a frame; what is missing for it is counted."""
        view_options, is_open = shown.view_options, "counting" in shown.view_options.panels
        subject = self.presenter.current_subject(mapped=view_options.flow_map)
        if view_options.counts or is_open or view_options.flow_map:
            self._ask(subject)
        self._floor.show_flow(self.presenter.flow() if view_options.flow_map else None)
        doing = tr("Counting...") if self._search.busy else ""
        self._panel.show_scene(self.presenter.scene(shown.state, doing) if is_open else None)

    def marker(self, view_options: ViewOptions) -> Marker | None:
        """What is counted at lines and regions that are drawn already."""
        if not view_options.counts:
            return None
        texts = self.presenter.shape_texts()

        def mark(marks: PictureMarks, _: Side, state: FrameState, __: int) -> PictureMarks:
            told = with_texts(marks.labels.outlines, partial(texts.describe, state))
            return replace(marks, labels=replace(marks.labels, outlines=told))

        return mark

    def floor_marker(self, view_options: ViewOptions) -> FloorMarker | None:
        """The same on the floor; and the flow map, where it is shown."""
        flow = self.presenter.flow() if view_options.flow_map else None
        texts = self.presenter.shape_texts() if view_options.counts else None

        def mark(marks: FloorMarks, state: FrameState) -> FloorMarks:
            labels = marks.labels
            if texts is not None:
                told = with_texts(labels.outlines, partial(texts.describe, state))
                labels = replace(labels, outlines=told)
            return replace(marks, labels=labels, flow=flow)

        return mark

    def texts_at(self, state: FrameState, view_options: ViewOptions) -> CountText:
        """Gives what to write at lines and regions in a frame."""
        if not view_options.counts:
            return lambda *_: ""
        return cache(partial(self.presenter.shape_texts().describe, state))

    def _ask(self, subject: CountSubject) -> None:
        if not subject.is_empty:
            self._search.ask(subject)

    def _prepare(self, subject: CountSubject) -> Work:
        """Takes hold of the tracks; counting them is for another thread."""
        document = self._document
        load, recording = capture_rows(document, subject.track_source), document.recording
        length = Length(recording.fps, recording.frame_count, self.presenter.frames)
        bounds = self._bounds()
        return lambda report: count_subject(subject, load, length, bounds, report)

    def _take(self, found: CountResult) -> None:
        self.presenter.take(found)

    def _refuse(self, subject: CountSubject, error: Exception) -> None:
        self.presenter.refuse(subject, error)

    # choices

    def _pick(self, is_line: bool, name: str) -> None:
        self.presenter.pick(is_line, name)
        self.marked.emit()

    def _choose_track_source(self, number: int) -> None:
        self.presenter.choice.track_source = number - 1 if number > 0 else SHOWN
        self.marked.emit()

    def _choose_step(self, step_s: float) -> None:
        self._settle(step_s=step_s)

    def _choose_jitter(self, jitter_m: float) -> None:
        self._settle(jitter_m=jitter_m)

    def _choose_jitter_px(self, jitter_px: float) -> None:
        self._settle(jitter_px=jitter_px)

    def _settle(self, **values: float) -> None:
        """Count in another way from now on."""
        self.presenter.choice.settings = replace(self.presenter.choice.settings, **values)
        self.marked.emit()

    def _tell_copied(self, steps: int) -> None:
        self.said.emit(count_text(steps, "{n} step copied", "{n} steps copied"))
