"""Body parts of the open recording: rectangles, particles, plots, walking failures."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QRectF

from app.core.feature import FeatureContext, FeatureController, Marker, ShownFrame
from app.core.i18n import tr
from app.core.scenes import Side
from app.core.scenes.part_names import no_parts, part_name
from app.core.scenes.picture_marks import PictureMarks
from app.core.scenes.pictured_parts import PicturedParts
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.parts.panel import CurvesPanel
from app.features.parts.part_views import part_boxes
from app.features.parts.presenter import PartsPresenter
from app.features.parts.scene import Failure

_SMALL = 0.25
"""Of the height of the view: parts of somebody smaller are hard to tell apart."""


class PartsController(FeatureController):
    """Shows the parts that a tracker saw.

    Signals: `changed()`, another person or part is looked at.
    """

    def __init__(self, context: FeatureContext, panel: CurvesPanel) -> None:
        super().__init__(context.parent)
        self._document, self._playback = context.document, context.playback
        self._panel, self._picture, self._labels = panel, context.surfaces.left, context.labels
        self.presenter = PartsPresenter(context.document, lambda: context.labels.part)
        panel.frame_sought.connect(context.playback.go)
        self._picture.part_picked.connect(context.labels.choose_part)

    def close(self) -> None:
        """Leave nothing on the views, which outlive the document."""
        self._picture.show_parts(PicturedParts())
        self._panel.show_scene(None)

    def draw_frame(self, shown: ShownFrame) -> None:
        """Show a frame."""
        labels, state, options = self._labels, shown.state, shown.view_options
        parts = self.presenter.picture(state, options, labels.shown, labels.suggested)
        self._picture.show_parts(parts)
        curves = self.presenter.curves(state) if "curves" in options.panels else None
        self._panel.show_scene(curves)

    def marker(self, view_options: ViewOptions) -> Marker | None:
        """The rectangles of the parts, without what is said of them."""
        if not view_options.parts:
            return None
        part = self._labels.part

        def mark(marks: PictureMarks, side: Side, state: FrameState, _: int) -> PictureMarks:
            boxes = part_boxes(state, part) if side is Side.LEFT else ()
            return replace(marks, parts=PicturedParts(boxes))

        return mark

    def jump(self, step: int) -> bool:
        """Go to the next (1) or previous (-1) failure of the selected person, then of others.

        Whether there was one to go to.
        """
        if self._document.shows_further_run:
            self._playback.stay()  # moving shows the session's tracks: look among those
        frame, track = self._playback.clock.frame, self._document.selection.track
        failure = self.presenter.next_failure(frame, step)
        if failure is None:
            self.said.emit(self._no_failure(step))
            return False
        self._playback.pause()
        self._document.correcting.leave()
        self._document.selection.choose(failure.track)
        self._labels.choose_part(failure.part)
        self._playback.go(failure.frame)
        self._come_near(failure)
        done = self._done_with(track, step) if track not in (0, failure.track) else ""
        self.said.emit(done + self._told(failure))
        self.changed.emit()
        return True

    def _come_near(self, failure: Failure) -> None:
        """Small people are seen large; of the others all stays as it is, where they are in view."""
        box, view = self.presenter.person_box(failure.frame, failure.track), self._picture
        if box is None:
            return
        place = view.viewport.rect(QRectF(*box))
        small = place.height() < _SMALL * view.height()
        if small or not QRectF(view.rect()).contains(place.center()):
            view.show_close(QRectF(*box))

    def _told(self, failure: Failure) -> str:
        who = self._document.label(failure.track).name
        said = tr("The {part} of {track} begins to fail in frame {frame}")
        if failure.by_rule:
            said = tr(
                "The {part} of {track} begins to fail in frame {frame}, by a rule of the tracker;"
                " the part-failure detector did not report it"
            )
        track = f"{failure.track} {who}".rstrip()
        return said.format(part=part_name(failure.part), track=track, frame=failure.frame)

    def _done_with(self, track: int, step: int) -> str:
        if step > 0:
            return tr("No further failure of {track}, next person. ", track=track)
        return tr("No earlier failure of {track}, previous person. ", track=track)

    def tell_what_is_missing(self, *, for_one: bool) -> None:
        """Say why nothing is seen: no parts, or nobody selected for what is one person's."""
        number = self._playback.number
        if not (self.presenter.any_tracked or len(self._document.tracks.parts(number)["part"])):
            self.said.emit(tr(no_parts()))
        elif for_one and not self._document.selection:
            self.said.emit(tr("Click a person to see the particles of their parts"))

    def _no_failure(self, step: int) -> str:
        if not self.presenter.any_tracked:
            return tr(no_parts())
        if step > 0:
            return tr("No part of anybody fails after this frame")
        return tr("No part of anybody fails before this frame")
