"""One camera's picture with the people marked on it."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QWidget

from app.core.drawing.name_plates import draw_message
from app.core.drawing.part_marks import part_box_at, said_at
from app.core.drawing.people_marks import draw_cross
from app.core.drawing.surfaces import PictureSurface
from app.core.i18n import tr
from app.core.look.theme import Theme
from app.core.scenes import PersonMark, PictureScene, Side
from app.core.scenes.picture_marks import PictureMarks
from app.core.widgets.spoken_description import SpokenDescription, told_lines, told_people
from app.features.pictures.box_handles import (
    INSIDE,
    Grip,
    cursor_of,
    draw_handles,
    draw_outline_beyond,
    handle_at,
)
from app.features.pictures.divider import is_at_divider, share_at
from app.features.pictures.picture_painter import (
    PictureInput,
    PicturePainter,
    image_from_bgr,
    image_from_rgba,
)

_PICK_REACH_PX = 10.0


def _told_mark(person: PersonMark) -> str:
    """Somebody's name, and what the box's line says: that it is dotted or dashed."""
    if person.occluded:
        return tr("{name} (occluded)", name=person.label)
    return tr("{name} (predicted)", name=person.label) if person.predicted else person.label


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
        self._dividing = False
        self._dragged = False
        self._hover: QPointF | None = None
        self._painter = PicturePainter()
        self._over = 0
        self._spoken = SpokenDescription(self, self._words)
        self._rename()

    def show_scene(self, scene: PictureScene) -> None:
        """Draw another frame."""
        before, previous = self._image.size(), self._scene
        self._scene = scene
        if scene.drawing and not previous.drawing:
            self._hover = self.pointed_at  # not where the mouse was when a box was drawn last
        if scene.image is not previous.image:
            self._image = image_from_bgr(scene.image)
        if scene.overlay is not previous.overlay:
            self._overlay = image_from_rgba(scene.overlay)
        if scene.side is not previous.side:
            self._rename()
        if self._image.size() != before:
            self.fit()
        self._spoken.changed()
        self.update()

    def _words(self) -> str:
        """The frame, who is marked in it, who of them is selected."""
        scene = self._scene
        people = [_told_mark(one) for one in scene.people]
        selected = [one.label for one in scene.people if one.selected]
        frame = tr("Frame {frame}", frame=scene.frame)
        return told_lines(frame, *told_people(people, selected), scene.message)

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

    @property
    def _place(self) -> QRectF:
        """Where all of the picture is."""
        return self.viewport.rect(self.content())

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
        self._dividing = is_at_divider(self._divider, self._place, at)
        if self._dividing:
            return True
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
        """Tell where the box, or the divider, is by now."""
        if self._dividing:
            self.divider_moved.emit(share_at(self._place, at))
            return
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
        if self._dividing:
            self._dividing = False
            return
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
        """A cross to draw, arrows over handles and the divider, a hand over people."""
        if is_at_divider(self._divider, self._place, at):
            return Qt.CursorShape.SplitHCursor
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
        if self._hover is not None:
            self._hover = None
            self.update()

    def _point_at(self, track: int) -> None:
        """Whoever is under the cursor is named, also where that hides somebody."""
        before, self._over = self._over, track
        goes = before != 0 and before == self._painter.naming.forced
        if before != track and (goes or track not in self._painter.naming.named | {0}):
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
        """The person whose name or box is hit; of several, the one whose middle is nearest."""
        plates = self._painter.naming.plates
        named = next((track for track, plate in plates if plate.contains(at)), 0)
        for person in self._scene.people:
            if named == person.track:  # names lie on top of people
                return person
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
        if self._image.isNull():
            draw_message(painter, QRectF(self.rect()), self._scene.message, theme)
        else:
            self._painter.paint(painter, self._pictured(), theme, self._draw_handles)

    def _pictured(self) -> PictureInput:
        drawn = self._labels, self._parts, self._others, self._truth, self._detections
        marks = PictureMarks(*drawn, self._divider, self._suggested)
        return PictureInput(
            self._scene,
            marks,
            self._image,
            self._overlay,
            self.viewport,
            QRectF(self.rect()),
            self.font(),
            self.fontMetrics().lineSpacing(),
            self._camera_name,
            self._over,
        )

    def _draw_handles(self, painter: QPainter, shown: QRectF) -> None:
        """What can be taken hold of, and where the box that is drawn would begin."""
        movable = self._movable()
        if movable is not None and not self._labels.labelling:
            rect = self.viewport.rect(QRectF(*movable.box))
            draw_outline_beyond(painter, rect, QColor(*movable.colour), shown)
            draw_handles(painter, rect, QColor(*movable.colour))
        if self._scene.drawing and self._hover is not None and self._place.contains(self._hover):
            draw_cross(painter, self._hover, shown)
