"""What the detector is wrong about, as small pictures that take one there."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QImage, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QListView, QListWidget, QListWidgetItem, QWidget

from app.core.drawing.name_plates import draw_message
from app.core.i18n import joined_text, tr
from app.core.jobs.jobs import Job, Progress
from app.core.look.theme import current_theme
from app.features.parts.mistake_pictures import Cut, Cuts
from app.features.parts.training_result import MistakeItem

Cutter = Callable[[Sequence[MistakeItem], Progress], Cuts]
"""Cuts mistakes out of their pictures; None where a picture is not at hand."""

_LINES, _WORD_LINES = 6, 5


class MistakesList(QListWidget):
    """Thumbnails of mistakes; they are cut out off the GUI thread.

    Signals:
        sought(object): a :class:`MistakeItem` was chosen by a click or Enter.
        failed(object): the error for which pictures are missing.
    """

    sought = Signal(object)
    failed = Signal(object)

    def __init__(self, cut: Cutter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._cut = cut
        self._job: Job | None = None
        self._items: tuple[MistakeItem, ...] = ()
        self._pictures: Cuts = {}
        self._given_up = False
        side = _LINES * self.fontMetrics().height()
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setFlow(QListView.Flow.LeftToRight)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setMovement(QListView.Movement.Static)
        self.setWordWrap(True)
        self.setIconSize(QSize(side, side))
        words = _WORD_LINES * self.fontMetrics().height()
        self.setGridSize(QSize(round(1.7 * side), side + words + 16))
        self.setSpacing(4)
        self.setMinimumHeight(side + words + 24)
        self.setAccessibleName(tr("Mistakes, the most informative first"))
        self.itemActivated.connect(self._seek)
        self.itemClicked.connect(self._seek)

    def show_items(self, items: Sequence[MistakeItem]) -> None:
        """Show other mistakes; pictures that were cut stay."""
        if tuple(items) == self._items:
            return
        self._items, self._given_up = tuple(items), False
        elided, room = self.fontMetrics().elidedText, self.gridSize().width() - 12
        self.clear()
        for one in self._items:
            recording = elided(one.recording, Qt.TextElideMode.ElideMiddle, room)
            frame = tr("frame {0}").format(one.frame)
            entry = QListWidgetItem(f"{one.title}\n{frame}\n{recording}\n{one.said}")
            where = joined_text(", ", filter(None, (one.title, one.recording, frame, one.when)))
            entry.setToolTip(f"{where}: {one.said}")
            entry.setSizeHint(self.gridSize())
            entry.setData(Qt.ItemDataRole.AccessibleTextRole, entry.toolTip())
            entry.setTextAlignment(Qt.AlignmentFlag.AlignHCenter)
            self.addItem(entry)
        self._draw_known()
        if self._job is None:
            self._begin()

    def close_pictures(self) -> None:
        """End the thread."""
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()

    def _begin(self) -> None:
        missing = [one for one in self._items if one not in self._pictures]
        if not missing:
            return

        def work(progress: Progress) -> object:
            return self._cut(missing, progress)

        self._job = Job(tr("Reading pictures"), work, self)
        self._job.done.connect(self._take)
        self._job.failed.connect(self._fail)
        self._job.cancelled.connect(self._give_up)
        self._job.start()

    def _take(self, found: Cuts) -> None:
        self._pictures.update(found)
        self._end()
        self._draw_known()
        # Others may have been asked for meanwhile.
        self._begin()

    def _fail(self, error: Exception) -> None:
        self._end()
        self.failed.emit(error)

    def _give_up(self) -> None:
        """The user cancelled it: pictures that are not read stay so until others are shown."""
        self._end()
        self._given_up = True
        self._draw_known()

    def _end(self) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None

    def _draw_known(self) -> None:
        word = tr("not read") if self._given_up else tr("Reading...")
        coming = _icon(None, self.iconSize(), word, self)
        missing = tr("image not found")
        for row, one in enumerate(self._items):
            if one in self._pictures:
                icon = _icon(self._pictures[one], self.iconSize(), missing, self)
            else:
                icon = coming
            self.item(row).setIcon(icon)

    def _seek(self, entry: QListWidgetItem) -> None:
        self.sought.emit(self._items[self.row(entry)])


def _icon(cut: Cut | None, size: QSize, missing: str, on: QWidget) -> QIcon:
    """The piece of picture with the rectangle, or a field that says what is missing."""
    ratio = on.devicePixelRatioF()
    drawn = QPixmap(size * ratio)
    drawn.setDevicePixelRatio(ratio)
    drawn.fill(current_theme().sunken)
    if cut is None:
        painter = QPainter(drawn)
        painter.setFont(on.font())
        draw_message(painter, QRectF(QPointF(), size.toSizeF()), missing, current_theme())
        painter.end()
    else:
        piece, (left, top, width, height) = cut
        rows, columns = piece.shape[:2]
        data = np.ascontiguousarray(piece)
        image = QImage(data.data, columns, rows, 3 * columns, QImage.Format.Format_BGR888)
        scale = min(size.width() / columns, size.height() / rows)
        painter = QPainter(drawn)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.translate((size.width() - scale * columns) / 2, (size.height() - scale * rows) / 2)
        painter.scale(scale, scale)
        painter.drawImage(0, 0, image)
        for colour, pen in ((QColor(0, 0, 0), 3.0), (QColor(255, 255, 255), 1.4)):
            painter.setPen(QPen(colour, pen / scale))
            painter.drawRect(QRectF(left, top, width, height))
        painter.end()
    return QIcon(drawn)
