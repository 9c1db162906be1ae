"""One camera's picture with the people marked on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter, QPen
from PySide6.QtWidgets import QWidget

from app.core.drawing.compare_marks import draw_other_boxes
from app.core.drawing.detection_marks import draw_detections
from app.core.drawing.label_marks import (
    draw_outline_names,
    draw_outlines,
    draw_parts,
    place_outline_names,
)
from app.core.drawing.name_plates import draw_message
from app.core.drawing.part_cards import draw_cards
from app.core.drawing.part_marks import draw_part_boxes, draw_part_particles, part_box_at, said_at
from app.core.drawing.people_marks import draw_cross, draw_ghosts, draw_people, draw_preview
from app.core.drawing.suggested_marks import draw_suggested
from app.core.drawing.surfaces import PictureSurface
from app.core.drawing.truth_marks import draw_truth_boxes
from app.core.i18n import tr
from app.core.look.theme import Theme, scaled_font
from app.core.scenes import LegendEntry, PersonMark, PictureScene, Side
from app.features.pictures.box_handles import INSIDE, Grip, cursor_of, draw_handles, handle_at
from app.features.pictures.box_names import BoxNameInput, BoxNamePainter
from app.features.pictures.captions import Captions, draw_captions, lay_out
from tracking.recording.frame import Image

_PICK_REACH_PX = 10.0
_SMALL = 0.78
_LOW_LINES = 18
"""In a picture lower than so many lines of text legends and cards hide people."""


class PictureView(PictureSurface):
    """Draws a :class:`PictureScene`.

    Signals:
        box_grabbed(int), box_dragged(object), box_dropped(): a person's box, or for 0 the one
            with handles or being drawn, is held, is now (left, top, width, height), is let go.
    """

    box_grabbed = Signal(int)
    box_dragged = Signal(object)
    box_dropped = Signal()

    def __init__(self, side: Side, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene = PictureScene(side, 0, None)
        self._image = QImage()
        self._overlay = QImage()
        self._camera_name = ""
        self._alone = False
        self._grip: Grip | None = None
        self._held = 0
        self._dragged = False
        self._hover: QPointF | None = None
        self._naming = BoxNamePainter()
        self._over = 0
        self._rename()

    def show_scene(self, scene: PictureScene) -> None:
        """Draw another frame."""
        before, previous = self._image.size(), self._scene
        self._scene = scene
        if scene.image is not previous.image:
            self._image = _from_bgr(scene.image)
        if scene.overlay is not previous.overlay:
            self._overlay = _from_rgba(scene.overlay)
        if scene.side is not previous.side:
            self._rename()
        if self._image.size() != before:
            self.fit()
        self.update()

    def show_person(self, track: int) -> None:
        """Have a person seen who may stand outside of a zoomed view."""
        box = next((one.box for one in self._scene.people if one.track == track), None)
        if box is not None:
            self.bring_into_view(QRectF(*box))

    def set_alone(self, alone: bool) -> None:
        """Be called a camera, or where there is one camera only, the picture."""
        if alone is not self._alone:
            self._alone = alone
            self._rename()
            self.update()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Follow the language."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.LanguageChange:
            self._rename()

    def _rename(self) -> None:
        names = {
            Side.LEFT: tr("Image") if self._alone else tr("Left camera"),
            Side.RIGHT: tr("Right camera"),
            Side.BOTH: tr("Both cameras, for red and cyan glasses"),
        }
        self._camera_name = names[self._scene.side]
        self.setAccessibleName(self._camera_name)

    def content(self) -> QRectF:
        """The picture; its first pixel's centre lies at (0, 0)."""
        if self._image.isNull():
            return QRectF()
        return QRectF(-0.5, -0.5, self._image.width(), self._image.height())

    def clicked_at(self, at: QPointF, extend: bool) -> None:
        """Report who and where."""
        if self._image.isNull():
            return
        part = part_box_at(self._parts.boxes, at, self.viewport)
        if part is not None and part.selected and part.track == self.track_at(at) and not extend:
            self.part_picked.emit(part.part)
        (self.track_added if extend else self.track_picked).emit(self.track_at(at))
        place = self.viewport.to_content(at)
        self.picture_clicked.emit(place.x(), place.y())

    def track_at(self, at: QPointF) -> int:
        """The person there."""
        person = self._person_at(at)
        return person.track if person is not None else 0

    # moving and drawing boxes

    def grabs(self, at: QPointF) -> bool:
        """A new box's corner while one is to be drawn, else a handle, or anybody's box."""
        self._grip, self._held, self._dragged = self._grip_at(at), 0, False
        if self._grip is None and (person := self._inside(at)) is not None:
            self._grip = Grip(INSIDE, person.box, self.viewport.to_content(at))
            self._held = person.track
        return self._grip is not None

    def _inside(self, at: QPointF) -> PersonMark | None:
        """Whose box can be moved from here, though it has no handles."""
        person = self._person_at(at) if self._scene.movable else None
        inside = person is not None and self.viewport.rect(QRectF(*person.box)).contains(at)
        return person if inside else None

    def _grip_at(self, at: QPointF) -> Grip | None:
        place = self.viewport.to_content(at)
        if self._scene.drawing and not self._image.isNull():
            return Grip((1, 1), (place.x(), place.y(), 0.0, 0.0), place)
        person = self._movable()
        if person is None:
            return None
        handle = handle_at(self.viewport.rect(QRectF(*person.box)), at)
        return Grip(handle, person.box, place) if handle is not None else None

    def _movable(self) -> PersonMark | None:
        return next((person for person in self._scene.people if person.movable), None)

    def drag_to(self, at: QPointF) -> None:
        """Tell where the box is by now."""
        if self._grip is not None and not self._dragged:
            self._grip = self._grip_by_now(self._grip)
            if self._grip is not None:
                self._dragged = True
                self.box_grabbed.emit(self._held)
        if self._grip is None:
            return
        self._hover = at
        self.box_dragged.emit(self._grip.moved_to(self.viewport.to_content(at)))

    def drop(self) -> None:
        """Tell that the box stays."""
        self._grip = None
        if self._dragged:
            self.box_dropped.emit()

    def _grip_by_now(self, grip: Grip) -> Grip | None:
        """While playing the box is not that of the press any more; None: nobody is there now."""
        if self._scene.drawing:
            return grip
        held = (one for one in self._scene.people if one.track == self._held)
        person = next(held, None) if self._held else self._movable()
        return replace(grip, box=person.box) if person is not None else None

    def cursor_at(self, at: QPointF) -> Qt.CursorShape:
        """A cross to draw, arrows over handles, a hand over people."""
        person = None if self._scene.drawing else self._person_at(at)
        self._point_at(person.track if person is not None else 0)
        if self._scene.drawing:
            self._hover = at
            self.update()
            return Qt.CursorShape.CrossCursor
        grip = self._grip_at(at)
        if grip is not None:
            return cursor_of(grip.handle)
        return Qt.CursorShape.PointingHandCursor if person else Qt.CursorShape.ArrowCursor

    def leaveEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Nobody is under the cursor any more."""
        super().leaveEvent(event)
        self._point_at(0)

    def _point_at(self, track: int) -> None:
        """Whoever is under the cursor is named, also where that hides somebody."""
        before, self._over = self._over, track
        goes = before != 0 and before == self._naming.forced
        if before != track and (goes or track not in self._naming.named | {0}):
            self.update()

    def name_at(self, at: QPointF) -> str:
        """The person's label under the cursor, and what is said of the part there."""
        person = self._person_at(at)
        if person is None:
            return ""
        name = person.label
        if person.predicted:
            name = tr("{0} (predicted)").format(name)
        said = said_at(self._parts, at, self.viewport, person.track)
        return f"{name}\n{said}" if said else name

    def _person_at(self, at: QPointF) -> PersonMark | None:
        """The person whose box is hit; of several, the one whose middle is nearest."""
        reach = _PICK_REACH_PX
        hits = []
        for person in self._scene.people:
            rect = self.viewport.rect(QRectF(*person.box))
            if rect.adjusted(-reach, -reach, reach, reach).contains(at):
                outside = 0.0 if rect.contains(at) else 1e6
                hits.append((outside + QLineF(rect.center(), at).length(), person))
        return min(hits, key=lambda hit: hit[0])[1] if hits else None

    def paint(self, painter: QPainter, theme: Theme) -> None:
        """Picture, overlay, grid, people, the camera's name, what colours mean."""
        area = QRectF(self.rect())
        if self._image.isNull():
            draw_message(painter, area, self._scene.message, theme)
            return
        self._draw_image(painter)
        self._draw_grid(painter)
        painter.setFont(scaled_font(self.font(), 0.92, bold=True))
        shown = area.intersected(self.viewport.rect(self.content()))
        outlines = self._labels.outlines
        draw_outlines(painter, outlines, self.viewport, theme)
        labels = place_outline_names(QFontMetricsF(painter.font()), outlines, self.viewport, shown)
        draw_preview(painter, self._scene.preview, self.viewport)
        draw_ghosts(painter, self._scene.ghosts, self.viewport)
        draw_detections(painter, self._detections, self.viewport)
        draw_other_boxes(painter, self._others, self.viewport, theme, shown)
        draw_suggested(painter, self._suggested, self.viewport, theme, shown)
        captions = self._lay_out_captions(area)
        draw_people(painter, self._scene.people, self.viewport)
        self._draw_parts(painter, shown)
        draw_outline_names(painter, labels, theme)
        kept_off = [*captions.taken, *(label.rect for label in labels)]
        names = self._draw_names(painter, shown, kept_off)
        draw_truth_boxes(painter, self._truth, self.viewport, theme, shown)
        movable = self._movable()
        if movable is not None and not self._labels.labelling:
            rect = self.viewport.rect(QRectF(*movable.box))
            draw_handles(painter, rect, QColor(*movable.colour))
        if self._scene.drawing and self._hover is not None:
            draw_cross(painter, self._hover, shown)
        painter.setFont(scaled_font(self.font(), 0.92))
        self._draw_cards(painter, area, [*names, *kept_off], theme)
        draw_captions(painter, captions, *self._words, theme)

    def _draw_names(
        self, painter: QPainter, shown: QRectF, taken: Sequence[QRectF]
    ) -> list[QRectF]:
        """Where they stand; small ones in a low picture, in which they would hide most of all."""
        font = scaled_font(self.font(), _SMALL if self._low else 0.92, bold=True)
        people, view = self._scene.people, self.viewport
        boxed = BoxNameInput(people, view, shown, taken, font, small=self._low)
        return self._naming.draw(painter, boxed, self._over)

    def _draw_parts(self, painter: QPainter, shown: QRectF) -> None:
        """Rectangles and particles, below everybody's names: a crowd has many."""
        draw_part_boxes(painter, self._parts.boxes, self.viewport, shown)
        draw_parts(painter, self._labels.parts, self.viewport)
        size = (self.width(), self.height())
        draw_part_particles(painter, self._parts, self.viewport, size)

    @property
    def _words(self) -> tuple[str, str, tuple[LegendEntry, ...]]:
        """The camera's name, the message, what colours mean."""
        told = () if self._low and self._truth.floor_tells else self._truth.legend
        return (
            self._camera_name,
            self._scene.message,
            (*told, *self._detections.legend, *self._scene.legend),
        )

    def _lay_out_captions(self, area: QRectF) -> Captions:
        """Before people's names, which keep clear of them."""
        metrics = QFontMetricsF(scaled_font(self.font(), 0.92))
        people = [self.viewport.rect(QRectF(*one.box)) for one in self._scene.people]
        return lay_out(metrics, area, *self._words, people)

    @property
    def _low(self) -> bool:
        return self.height() < _LOW_LINES * self.fontMetrics().lineSpacing()

    def _draw_cards(
        self, painter: QPainter, area: QRectF, taken: list[QRectF], theme: Theme
    ) -> None:
        """What is said of parts: also beside the picture, where there is room.

        A low picture has room for the selected person's alone.
        """
        people = {one.track: self.viewport.rect(QRectF(*one.box)) for one in self._scene.people}
        inside = area.adjusted(2, 2, -2, -2)
        cards = [one for one in self._parts.cards if one.selected or not self._low]
        draw_cards(painter, cards, self.viewport, inside, people, taken, theme)

    def _draw_image(self, painter: QPainter) -> None:
        target = self.viewport.rect(self.content())
        shrunk_or_near = self.viewport.scale < 3.0
        hint = QPainter.RenderHint.SmoothPixmapTransform
        painter.setRenderHint(hint, shrunk_or_near)
        painter.drawImage(target, self._image)
        if not self._overlay.isNull():
            painter.drawImage(target, self._overlay)

    def _draw_grid(self, painter: QPainter) -> None:
        segments = np.asarray(self._scene.grid, np.float64)
        if not len(segments):
            return
        ends = self.viewport.to_widget(segments.reshape(-1, 2)).reshape(-1, 4)
        ends = ends[np.isfinite(ends).all(axis=1)]
        painter.save()
        painter.setClipRect(self.viewport.rect(self.content()))  # the floor goes on beside it
        painter.setPen(QPen(QColor(255, 255, 255, 90), 1.0))
        painter.drawLines([QLineF(*row) for row in ends.tolist()])
        painter.restore()


def _from_bgr(image: Image | None) -> QImage:
    """A picture of our own, so that the frame cache may drop its array."""
    if image is None:
        return QImage()
    rows, columns = image.shape[:2]
    four = cv2.cvtColor(image, cv2.COLOR_BGR2BGRA)  # a fifth of the time Qt takes
    return QImage(four.data, columns, rows, 4 * columns, QImage.Format.Format_RGB32).copy()


def _from_rgba(overlay: Image | None) -> QImage:
    if overlay is None:
        return QImage()
    rows, columns = overlay.shape[:2]
    packed = np.ascontiguousarray(overlay)
    shared = QImage(packed.data, columns, rows, 4 * columns, QImage.Format.Format_RGBA8888)
    return shared.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)
