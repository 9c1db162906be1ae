"""Labelling in the open recording: tools, gestures and keys become labels."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QObject, QPointF, QRectF
from PySide6.QtWidgets import QWidget

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.drawing.surfaces import Surfaces
from app.core.feature import FloorMarker, Marker
from app.core.i18n import tr
from app.core.playback.playback import Playback
from app.core.scenes import Side
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.labels import CountText, FloorLabels, PictureLabels, SuggestedPart, Tool
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.labelling.drawn_shapes import Shapes
from app.features.labelling.panel import LabellingPanel
from app.features.labelling.part_keys import PartKeys
from app.features.labelling.part_labels import PartsLayer
from app.features.labelling.presenter import LabellingPresenter
from app.features.labelling.scene import LabellingScene
from app.features.labelling.shapes import ShapesLayer
from tracking.editing import Change, plan_mark_reviewed, plan_unmark_reviewed
from tracking.errors import TrackwrightError


class LabelController(Controller):
    """Turns what is drawn and said into edits of a document, and shows it.

    Signals: `changed()`, labels or the tool are others than before.
    """

    def __init__(
        self,
        document: Document,
        playback: Playback,
        panel: LabellingPanel,
        surfaces: Surfaces,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._playback = playback
        self._panel, self._surfaces = panel, surfaces
        self._presenter = LabellingPresenter(document)
        self.shown = PictureLabels()
        self._refused: tuple[str, tuple[object, ...]] = ("", ())
        self._parts = PartsLayer(surfaces.left)
        self._shapes = Shapes(surfaces, playback, self._presenter, self._do, self)
        self._keys = PartKeys(document, playback, self._presenter.parts, self._do, self)
        self._keys.changed.connect(self.changed)
        self._keys.close_asked.connect(self._show_close)
        self._connect_layers()
        self._connect_panel()

    def _connect_layers(self) -> None:
        self._parts.part_chosen.connect(self.choose_part)
        self._parts.part_drawn.connect(self._keys.put_box)
        self._parts.picked.connect(self._pick_person)
        self._parts.leave_asked.connect(self.leave)
        self._shapes.changed.connect(self.changed)
        self._shapes.leave_asked.connect(self.leave)

    def _connect_panel(self) -> None:
        """Each connection ends with this object."""
        labelling, panel = self, self._panel
        panel.leave_asked.connect(labelling.leave)
        panel.parts.said.connect(labelling._say_of)
        panel.parts.chosen.connect(labelling.choose_part)
        panel.parts.step_chosen.connect(labelling._keys.set_step)
        panel.parts.scope_chosen.connect(labelling._keys.choose_scope)
        panel.parts.suggestion_chosen.connect(labelling._keys.go_to)
        panel.drawn.picked.connect(labelling._shapes.pick)
        panel.drawn.renamed.connect(labelling._shapes.rename)
        panel.drawn.removed.connect(labelling._shapes.remove)
        panel.ranges.frame_sought.connect(labelling._playback.go)
        panel.ranges.marked.connect(labelling._mark)
        panel.ranges.unmarked.connect(labelling._unmark)

    def close(self) -> None:
        """Take the layers off the views, which outlive the document."""
        self._keys.end_suggestions()
        for layer in self._layers:
            layer.hide()
            layer.setParent(None)
            layer.deleteLater()
        self._panel.show_scene(None)
        self._show(PictureLabels(), PictureLabels())
        self._surfaces.floor.show_labels(FloorLabels())

    @property
    def _layers(self) -> tuple[QWidget, ...]:
        return (self._parts, self._shapes.on_picture, self._shapes.on_floor)

    # tools

    @property
    def tool(self) -> Tool | None:
        """What is being labelled."""
        return self._presenter.choice.tool

    def toggle(self, tool: Tool) -> None:
        """Begin with a tool, or leave it where it is at work already."""
        if self.tool is tool:
            self.leave()
            return
        self._playback.pause()
        self._document.correcting.leave()
        self._presenter.choice.tool = tool
        self._presenter.choice.picked = -1
        self._keys.see_labels(self._presenter.labels.parts)
        self._keys.end_suggestions()
        for layer in self._layers:
            layer.hide()
        for used in self._layers_of(tool):
            used.begin()
        self.changed.emit()

    def leave(self) -> None:
        """Leave the tool; what was drawn and said stays."""
        self._presenter.choice.tool = None
        self._presenter.choice.picked = -1
        self._keys.end_suggestions()
        for layer in self._layers:
            layer.hide()
        self._surfaces.left.setFocus()
        self.changed.emit()

    def _layers_of(self, tool: Tool) -> tuple[PartsLayer | ShapesLayer, ...]:
        """Where a tool draws; the last one has the keyboard."""
        if tool is Tool.PARTS:
            return (self._parts,)
        picture = (self._shapes.on_picture,) if tool.in_picture else ()
        floor_known = self._document.recording.view is not None
        return (*picture, self._shapes.on_floor) if tool.on_floor and floor_known else picture

    # body parts

    @property
    def part(self) -> int:
        """The part that is looked at, labelled or not."""
        return self._keys.part

    def choose_part(self, part: int) -> None:
        """Look at a part; the next answer is about it."""
        self._keys.choose(part)

    def say(self, on_part: bool | None, part: int | None = None) -> None:
        """Say whether a part's rectangle lies on its part, then go on to the next one."""
        self._need_parts()
        self._keys.say(on_part, part)

    def suggest(self) -> None:
        """Begin to label where the detector is least sure, or leave that."""
        if self.suggests and self.tool is Tool.PARTS:
            self.leave()
            return
        self._need_parts()
        self._keys.begin_suggestions()

    @property
    def suggests(self) -> bool:
        """Whether parts are walked where the detector is least sure."""
        return self._keys.suggesting.asked

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self._keys.suggesting.colour_anew()

    @property
    def suggested(self) -> SuggestedPart | None:
        """What is looked at because the detector is unsure of it; None where it is not shown."""
        now = self._presenter.parts.choice.suggested
        here = (self._playback.number, self._document.selection.track)
        return now if now is not None and now.key[:2] == here else None

    def walk(self, step: int) -> None:
        """To the next (1) or previous (-1) suggestion."""
        self._keys.walk(step)

    def next_scope(self) -> None:
        """How far an answer goes: this frame, or the range that is set."""
        self._keys.next_scope()

    def forget(self) -> None:
        """Take back what was said of the part in the frame, or in the range."""
        self._keys.forget()

    def follow_edits(self) -> None:
        """An edit was taken back or done again: of a body part, it is looked at again."""
        if self.tool is Tool.PARTS:
            self._keys.follow_labels(self._presenter.labels.parts)

    def _need_parts(self) -> None:
        if self.tool is not Tool.PARTS:
            self.toggle(Tool.PARTS)

    def _say_of(self, part: int, on_part: bool | None) -> None:
        """One of the panel's answers was clicked."""
        self.say(on_part, part)

    def _show_close(self, box: tuple[float, float, float, float] | None) -> None:
        """Small parts are judged from near."""
        if box is None:
            self._surfaces.left.fit()
        else:
            self._surfaces.left.show_close(QRectF(*box))

    def _pick_person(self, at: QPointF) -> None:
        """A click beside all rectangles: maybe on another person."""
        view = self._surfaces.left
        view.track_picked.emit(view.track_at(at))

    # reviewed ranges

    def _mark(self, everybody: bool, start: int, end: int) -> None:
        track, session = 0 if everybody else self._presenter.track, self._document.session
        table = session.tracks if session is not None else None
        self._do(lambda: plan_mark_reviewed(self._presenter.labels, track, start, end, table))

    def _unmark(self, track: int, start: int, end: int) -> None:
        self._do(lambda: plan_unmark_reviewed(self._presenter.labels, track, start, end))

    def _do(self, plan: Callable[[], Change]) -> bool:
        """Do what is planned; whether it was done. What cannot be is told."""
        try:
            change = plan()
            self._document.apply(change)
        except TrackwrightError as error:
            self._refuse(error)
            return False
        self._keys.see_labels(self._presenter.labels.parts)
        self.said.emit(tr("Done: {what}", what=change.text))
        self.changed.emit()
        return True

    def _refuse(self, error: TrackwrightError) -> None:
        """Tell why not: of a part in the panel, for as long as it is true; else as any error."""
        if self.tool is Tool.PARTS:
            self._refused = (tr(error.message), self._here)
            self.said.emit(tr(error.message))
        else:
            self.failed.emit(error)
        self.changed.emit()

    @property
    def _here(self) -> tuple[object, ...]:
        """What an answer would be about: frame, person, how far it goes, what is said so far."""
        document, parts = self._document, self._presenter.parts
        about = (self._playback.number, document.selection.track, parts.choice.scope)
        return *about, document.correcting.marked, self._presenter.labels.parts

    # showing

    def draw(self, both: bool, shown: bool, count_text: CountText) -> None:
        """Show labels in the views.

        both: the right camera is shown too. shown: at all. count_text: what to write at what is
            drawn.
        """
        if self._document.flow is not None and self.tool is not None:
            self.leave()
            return
        frame, presenter = self._playback.number, self._presenter
        shown = shown or self.tool is not None
        nothing = PictureLabels()
        left = presenter.picture(Side.LEFT, frame, count_text) if shown else nothing
        right = presenter.picture(Side.RIGHT, frame, count_text) if shown and both else nothing
        self._show(left, right)
        self._surfaces.floor.show_labels(presenter.floor(count_text))
        if self.tool is Tool.PARTS:
            self._parts.show_parts(left.parts, presenter.parts.choice.part)
        self._shapes.draw()
        self._panel.show_scene(self._completed(presenter.scene(frame)))

    def marker(self, view_options: ViewOptions) -> Marker | None:
        """Takes hold of what was drawn, for clips: occluders, lines and regions, uncounted."""
        if not view_options.labels:
            return None
        drawn = {side: self._presenter.outlines(side) for side in (Side.LEFT, Side.RIGHT)}

        def mark(marks: PictureMarks, side: Side, _: FrameState, __: int) -> PictureMarks:
            return replace(marks, labels=PictureLabels(outlines=drawn[side]))

        return mark

    def floor_marker(self, view_options: ViewOptions) -> FloorMarker | None:
        """The same over the floor."""
        if not view_options.labels:
            return None
        drawn = self._presenter.floor_outlines()

        def mark(marks: FloorMarks, _: FrameState) -> FloorMarks:
            return replace(marks, labels=drawn)

        return mark

    def _completed(self, scene: LabellingScene | None) -> LabellingScene | None:
        """The scene with the suggestions, and why the last answer was not taken."""
        if scene is None:
            return None
        if self._refused[1] != self._here:
            self._refused = ("", ())
        return replace(self._keys.suggesting.shown(scene), refused=self._refused[0])

    def _show(self, left: PictureLabels, right: PictureLabels) -> None:
        self.shown = left
        self._surfaces.left.show_labels(left)
        self._surfaces.right.show_labels(right)
