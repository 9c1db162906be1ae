"""Scoring: truth over the views, errors on the timeline, the panel of figures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt, Signal

from app.core.document.track_sources import SHOWN
from app.core.feature import FeatureContext, FeatureController, FloorMarker, Marker, ShownFrame
from app.core.i18n import N_, joined_text, tr
from app.core.jobs.latest_job import LatestJob
from app.core.keymap import in_brackets, key_or_title
from app.core.plots.axis import TimeAxis
from app.core.scenes import Side
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.ground_truth import NO_TRUTH
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.scoring.panel import ScorePanel
from app.features.scoring.presenter import ScoringPresenter
from app.features.scoring.subject import ScoreResult, ScoreSubject, score_subject
from tracking.errors import TrackwrightError
from tracking.formats import track_endings
from tracking.progress import Progress
from tracking.scoring import ErrorKind

_TRUTHS = N_("Tracks ({endings})")


class ScoreController(FeatureController):
    """Scores in the background what is asked for, and shows it.

    `changed`: there is another score. Signals: `truth_asked(filters)`, a file with the ground truth
    is to be chosen, and `choose_file` gets it; `error_lanes(lanes)`, the errors by frame for the
    timeline, None for none; `concerned(concern)`, people of one frame are looked at.
    """

    concerned = Signal(object)
    truth_asked = Signal(str)
    error_lanes = Signal(object)

    def __init__(self, context: FeatureContext, panel: ScorePanel) -> None:
        super().__init__(context.parent)
        self._document, self._playback = context.document, context.playback
        self._panel, self._surfaces = panel, context.surfaces
        self.presenter = ScoringPresenter(context.document)
        context.document.annotate_edits = self.presenter.annotate_edits
        self._on = False
        self._search = LatestJob(tr("Scoring"), self._prepare, self)
        self._search.found.connect(self.presenter.take)
        self._search.failed.connect(self.presenter.refuse)
        self._search.cancelled.connect(self.presenter.refuse)
        self._search.changed.connect(self.changed, Qt.ConnectionType.QueuedConnection)
        self._connect(panel)

    def _connect(self, panel: ScorePanel) -> None:
        panel.truth_chosen.connect(self._choose_truth)
        panel.result_chosen.connect(self._choose_result)
        panel.floor_chosen.connect(self._choose_way)
        panel.threshold_chosen.connect(self._choose_threshold)
        panel.kind_shown.connect(self._choose_kind)
        panel.next_asked.connect(self.walk)

    def close(self) -> None:
        """End the thread; leave nothing on the views, which outlive the document."""
        self._search.stop()
        self._panel.show_scene(None)
        self._show_nothing()

    @property
    def known(self) -> bool:
        """Whether there are errors to be walked through."""
        return self.presenter.scored is not None

    # drawing

    def draw_frame(self, shown: ShownFrame) -> None:
        """Show a frame; what is missing for it is scored."""
        is_open = "score" in shown.view_options.panels
        self._on = is_open or shown.view_options.truth
        doing = tr("Scoring...") if self._ask() and self._search.busy else ""
        self._panel.show_scene(self.presenter.scene(doing) if is_open else None)
        if self._on:
            self._draw_truth(shown)
        else:
            self._show_nothing()

    def marker(self, view_options: ViewOptions) -> Marker | None:
        """The truth, where it is shown."""
        people = self.presenter.people if view_options.truth else None
        if people is None:
            return None
        scored = self.presenter.scored_version

        def mark(marks: PictureMarks, side: Side, state: FrameState, _: int) -> PictureMarks:
            return replace(marks, truth=people.picture(side, state, scored))

        return mark

    def floor_marker(self, view_options: ViewOptions) -> FloorMarker | None:
        """The same on the floor."""
        people = self.presenter.people if view_options.truth else None
        if people is None:
            return None
        scored = self.presenter.scored_version

        def mark(marks: FloorMarks, state: FrameState) -> FloorMarks:
            return replace(marks, truth=people.floor(state, scored))

        return mark

    def _ask(self) -> bool:
        """Have scored what is wanted; whether there is anything to be."""
        subject = self.presenter.current_subject() if self._on else None
        if subject is not None:
            self._search.ask(subject)
        return subject is not None

    def _draw_truth(self, shown: ShownFrame) -> None:
        view, people, state = self._surfaces, self.presenter.people, shown.state
        left, floor = NO_TRUTH
        right = left
        if people is not None and shown.view_options.truth:
            scored = self.presenter.scored_version
            left, floor = people.picture(Side.LEFT, state, scored), people.floor(state, scored)
            left = replace(left, floor_tells=view.floor.shows_floor)
            if shown.cameras == "both":
                right = people.picture(Side.RIGHT, state, scored)
        view.left.show_truth(left)
        view.right.show_truth(right)
        view.floor.show_truth(floor)
        self.error_lanes.emit(self.presenter.lanes())

    def _show_nothing(self) -> None:
        view, (picture, floor) = self._surfaces, NO_TRUTH
        view.left.show_truth(picture)
        view.right.show_truth(picture)
        view.floor.show_truth(floor)
        self.error_lanes.emit(None)

    def _prepare(self, subject: ScoreSubject) -> Callable[[Progress], ScoreResult]:
        """Takes hold of the tracks; scoring them is for another thread."""
        given, before = self.presenter.capture(subject), self.presenter.scored
        return lambda report: score_subject(subject, before, given, report)

    # walking

    def walk(self, step: int) -> None:
        """Go to the next error (1) or the one before (-1), of the kinds that are shown."""
        events, frame = self.presenter.events, self._playback.clock.frame
        if events is None:
            self.said.emit(
                tr(
                    "Nothing is scored yet: choose the ground truth{key}",
                    key=in_brackets("view.score"),
                )
            )
            return
        there = events.next_start(frame, step)
        if there is None:
            word = tr("after") if step > 0 else tr("before")
            self.said.emit(tr("No error {where} this frame", where=word))
            return
        beginning = events.beginning_at(there)
        self.said.emit(joined_text("; ", beginning.words()))
        self.go_to(there, beginning.tracks)

    def go_to(self, frame: int, tracks: Sequence[int]) -> None:
        """Show a frame, and select whom of the result it is about."""
        live = self._document.is_live
        self._playback.pause()
        self.concerned.emit(self.presenter.concern_at(frame))
        self._playback.go(frame)
        if self._document.is_live is not live:  # the session's are shown again, others than scored
            self.said.emit(
                tr(
                    "Your own tracks are in view again: {follow} shows the new ones",
                    follow=key_or_title("play.follow"),
                )
            )
            tracks = ()
        there = [track for track in tracks if track in self._document.tracks.ids]
        if there and self._document.flow is None and self.presenter.track_source == SHOWN:
            self._document.selection.choose_all(there)
        self.changed.emit()

    # choices

    def ask_truth(self) -> None:
        """Ask for a file with the truth."""
        endings = " ".join(f"*{each}" for each in track_endings())
        known = tr(_TRUTHS).format(endings=endings)
        self.truth_asked.emit(known)

    def choose_file(self, path: Path) -> None:
        """Take a file as truth."""
        try:
            self.presenter.choose_file(path)
        except TrackwrightError as error:
            self.failed.emit(error)
        self.changed.emit()

    def _choose_truth(self, number: int) -> None:
        sources = self.presenter.sources
        if number < len(sources):
            self.presenter.choice.source = sources[number]
        else:
            self.ask_truth()
        self.changed.emit()

    def _choose_result(self, number: int) -> None:
        self.presenter.choice.track_source = number - 1 if number > 0 else SHOWN
        self.changed.emit()

    def _choose_way(self, on_floor: bool) -> None:
        self.presenter.choose_floor(on_floor)
        self.changed.emit()

    def _choose_threshold(self, value: float) -> None:
        self.presenter.choose_threshold(value)
        self.changed.emit()

    def _choose_kind(self, kind: ErrorKind, shown: bool) -> None:
        self.presenter.show_kind(kind, shown)
        self.changed.emit()

    def show_range(self, axis: TimeAxis) -> None:
        """The timeline shows other frames."""
        first = int(axis.start)
        self.presenter.visible = (first, max(first + 1, round(axis.start + axis.frames)))
        self._ask()
