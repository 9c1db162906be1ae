"""One camera's picture with everything over it, drawn on a widget or on a picture of its own.

Nothing here asks a widget: pictures are painted on any thread.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPen

from app.core.drawing.compare_marks import draw_other_boxes
from app.core.drawing.detection_marks import draw_detections
from app.core.drawing.label_marks import (
    draw_outline_names,
    draw_outlines,
    draw_parts,
    place_outline_names,
)
from app.core.drawing.part_cards import draw_cards
from app.core.drawing.part_marks import draw_part_boxes, draw_part_particles
from app.core.drawing.people_marks import draw_ghosts, draw_people, draw_preview
from app.core.drawing.suggested_marks import draw_suggested
from app.core.drawing.truth_marks import draw_truth_corners, draw_truth_signs
from app.core.drawing.viewport import Viewport
from app.core.look.theme import Theme, scaled_font
from app.core.scenes import LegendEntry, PersonMark, PictureScene
from app.core.scenes.ground_truth import ErrorsOf, PicturedTruth
from app.core.scenes.other_people import OtherMark
from app.core.scenes.picture_marks import PictureMarks
from app.features.pictures.box_names import BoxNameInput, BoxNamePainter
from app.features.pictures.captions import Captions, draw_captions, lay_out
from app.features.pictures.divider import draw_divider, halves
from tracking.recording.frame import Image

_SMALL = 0.78
_LOW_LINES = 18
"""In a picture lower than so many lines of text legends and cards hide people."""

Handles = Callable[[QPainter, QRectF], None]


def _no_handles(_: QPainter, __: QRectF) -> None:
    """What a picture that nobody works on has."""


@dataclass(frozen=True, slots=True, eq=False)
class PictureInput:
    """All that decides how a picture looks.

    Attributes:
        image, overlay: the scene's as Qt has them. viewport: where the picture is drawn.
        area: of the view, in its units. font: of the view.
        line_px: how high a line of text is there. camera: its name; "" for none.
        over: the track under the cursor. captions: whether names, legends and cards are told.
        reserved: where other words stand.
    """

    scene: PictureScene
    marks: PictureMarks
    image: QImage
    overlay: QImage
    viewport: Viewport
    area: QRectF
    font: QFont
    line_px: float
    camera: str = ""
    over: int = 0
    captions: bool = True
    reserved: tuple[QRectF, ...] = ()

    @property
    def content(self) -> QRectF:
        """The picture; its first pixel's centre lies at (0, 0)."""
        return QRectF(-0.5, -0.5, self.image.width(), self.image.height())

    @property
    def shown(self) -> QRectF:
        """Where in the view there is picture."""
        return self.area.intersected(self.viewport.rect(self.content))

    @property
    def low(self) -> bool:
        """Whether words would hide people."""
        return self.area.height() < _LOW_LINES * self.line_px


_NO_CAPTIONS = Captions(QRectF(), QRectF(), QRectF())


@dataclass(slots=True)
class PicturePainter:
    """Draws pictures; names stay where they stood from one frame to the next.

    Attributes:
        naming: draws the names, and knows who has one.
    """

    naming: BoxNamePainter = field(default_factory=BoxNamePainter)
    _naming: BoxNamePainter = field(default_factory=BoxNamePainter)

    def paint(
        self, painter: QPainter, given: PictureInput, theme: Theme, handles: Handles = _no_handles
    ) -> None:
        """Picture, overlay, grid, people, the camera's name, what colours mean.

        handles: draws what can be taken hold of, above people and below words; told where the
            picture is.
        """
        scene, marks, view, shown = given.scene, given.marks, given.viewport, given.shown
        _draw_image(painter, given)
        _draw_grid(painter, given)
        painter.setFont(scaled_font(given.font, 0.92, bold=True))
        outlines = marks.labels.outlines
        with _within(painter, view.rect(given.content)):
            draw_outlines(painter, [one for one in outlines if not one.picked], view, theme)
        draw_outlines(painter, [one for one in outlines if one.picked], view, theme)
        metrics = QFontMetricsF(painter.font())
        labels = place_outline_names(metrics, outlines, view, shown, given.reserved)
        draw_preview(painter, scene.preview, view)
        draw_ghosts(painter, scene.ghosts, view)
        draw_detections(painter, marks.detections, view)
        own, other = halves(marks.divider, view.rect(given.content), shown)
        others = _as_people(marks.others) if marks.divider is not None else ()
        if marks.divider is None:
            draw_other_boxes(painter, marks.others, view, theme, other)
        draw_suggested(painter, marks.suggested, view, theme, shown)
        captions = _lay_out_captions(given)
        with _within(painter, own):
            draw_people(painter, scene.people, view)
        with _within(painter, other):
            draw_people(painter, others, view)
        with _within(painter, own):
            _draw_parts(painter, given)
        truths = list(_divided_truth(marks, shown, own, other))
        for truth, area in truths:  # below people's names, which they would hide
            with _within(painter, area):
                draw_truth_corners(painter, truth, view, theme)
        draw_outline_names(painter, labels, theme)
        kept_off = [*given.reserved, *captions.taken, *(label.rect for label in labels)]
        names = self._draw_names(self.naming, painter, given, scene.people, own, kept_off)
        if others:
            names += self._draw_names(self._naming, painter, given, others, other, kept_off)
        for truth, area in truths:
            with _within(painter, area):
                draw_truth_signs(painter, truth, view, theme, area)
        if marks.divider is not None:
            draw_divider(painter, marks.divider, view.rect(given.content), shown, theme)
        handles(painter, shown)
        painter.setFont(scaled_font(given.font, 0.92))
        if given.captions:
            _draw_cards(painter, given, own, [*names, *kept_off], theme)
            draw_captions(painter, captions, *_words(given), theme)

    def _draw_names(
        self,
        naming: BoxNamePainter,
        painter: QPainter,
        given: PictureInput,
        people: Sequence[PersonMark],
        area: QRectF,
        taken: Sequence[QRectF],
    ) -> list[QRectF]:
        """Where they stand; small ones in a low picture, in which they would hide most of all."""
        font = scaled_font(given.font, _SMALL if given.low else 0.92, bold=True)
        boxed = BoxNameInput(people, given.viewport, area, taken, font, small=given.low)
        return naming.draw(painter, boxed, given.over if naming is self.naming else 0)


def _as_people(others: Sequence[OtherMark]) -> tuple[PersonMark, ...]:
    """Another version's people where nobody of one's own is drawn: as these would be."""
    nowhere = np.zeros((0, 2))
    return tuple(
        PersonMark(
            track=int(one.label) if one.label.isdecimal() else 0,
            box=one.box,
            label=one.label,
            colour=one.colour,
            selected=False,
            predicted=False,
            trail=nowhere,
        )
        for one in others
    )


def _divided_truth(
    marks: PictureMarks, shown: QRectF, own: QRectF, other: QRectF
) -> Iterator[tuple[PicturedTruth, QRectF]]:
    """The truth and where it is drawn: its errors where the version is drawn that was scored."""
    truth = marks.truth
    if marks.divider is None:
        yield truth, shown
        return
    for version, area in ((ErrorsOf.SOLID, own), (ErrorsOf.DASHED, other)):
        yield truth if truth.errors_of is version else truth.without_errors, area


@contextmanager
def _within(painter: QPainter, area: QRectF) -> Iterator[None]:
    """Draw nothing beyond a part of the view."""
    painter.save()
    painter.setClipRect(area, Qt.ClipOperation.IntersectClip)
    yield
    painter.restore()


def _draw_parts(painter: QPainter, given: PictureInput) -> None:
    """Rectangles and particles, below everybody's names: a crowd has many."""
    marks, view = given.marks, given.viewport
    draw_part_boxes(painter, marks.parts.boxes, view, given.shown)
    draw_parts(painter, marks.labels.parts, view)
    size = (round(given.area.width()), round(given.area.height()))
    draw_part_particles(painter, marks.parts, view, size)


def _words(given: PictureInput) -> tuple[str, str, tuple[LegendEntry, ...]]:
    """The camera's name, the message, what colours mean."""
    truth = given.marks.truth
    told = () if given.low and truth.floor_tells else truth.legend
    legend = (*told, *given.marks.detections.legend, *given.scene.legend)
    return given.camera, given.scene.message, legend


def _lay_out_captions(given: PictureInput) -> Captions:
    """Before people's names, which keep clear of them."""
    if not given.captions:
        return _NO_CAPTIONS
    metrics = QFontMetricsF(scaled_font(given.font, 0.92))
    people = [given.viewport.rect(QRectF(*one.box)) for one in given.scene.people]
    return lay_out(metrics, given.area, *_words(given), people, given.reserved)


def _draw_cards(
    painter: QPainter, given: PictureInput, own: QRectF, taken: list[QRectF], theme: Theme
) -> None:
    """What is said of parts of those who are drawn: also beside the picture, where there is room.

    A low picture has room for the selected person's alone.
    """
    view = given.viewport
    people = {one.track: view.rect(QRectF(*one.box)) for one in given.scene.people}
    if given.marks.divider is not None:
        people = {track: rect for track, rect in people.items() if own.intersects(rect)}
    inside = given.area.adjusted(2, 2, -2, -2)
    cards = [one for one in given.marks.parts.cards if one.selected or not given.low]
    if given.marks.divider is not None:
        cards = [one for one in cards if one.track in people]
    draw_cards(painter, cards, view, inside, people, taken, theme)


def _draw_image(painter: QPainter, given: PictureInput) -> None:
    target = given.viewport.rect(given.content)
    shrunk_or_near = given.viewport.scale < 3.0
    hint = QPainter.RenderHint.SmoothPixmapTransform
    painter.setRenderHint(hint, shrunk_or_near)
    painter.drawImage(target, given.image)
    if not given.overlay.isNull():
        painter.drawImage(target, given.overlay)


def _draw_grid(painter: QPainter, given: PictureInput) -> None:
    segments = np.asarray(given.scene.grid, np.float64)
    if not len(segments):
        return
    ends = given.viewport.to_widget(segments.reshape(-1, 2)).reshape(-1, 4)
    ends = ends[np.isfinite(ends).all(axis=1)]
    painter.save()
    painter.setClipRect(given.viewport.rect(given.content))  # the floor goes on beside it
    painter.setPen(QPen(QColor(255, 255, 255, 90), 1.0))
    painter.drawLines([QLineF(*row) for row in ends.tolist()])
    painter.restore()


def image_from_bgr(image: Image | None) -> QImage:
    """A picture of our own, so that the frame cache may drop its array."""
    if image is None:
        return QImage()
    rows, columns = image.shape[:2]
    four = cv2.cvtColor(image, cv2.COLOR_BGR2BGRA)  # a fifth of the time Qt takes
    return QImage(four.data, columns, rows, 4 * columns, QImage.Format.Format_RGB32).copy()


def image_from_rgba(overlay: NDArray[np.uint8] | None) -> QImage:
    """The same of what is laid over one."""
    if overlay is None:
        return QImage()
    rows, columns = overlay.shape[:2]
    packed = np.ascontiguousarray(overlay)
    shared = QImage(packed.data, columns, rows, 4 * columns, QImage.Format.Format_RGBA8888)
    return shared.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)
