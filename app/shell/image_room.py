"""How wide the pictures of the cameras are: no wider than they fill."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QSplitter, QWidget

_LEAST_FLOOR = 0.4
"""Least share of the width of images and floor that the floor keeps."""
_IMAGES, _FLOOR, _SIDE = range(3)
"""What stands side by side."""
_IMAGES_END = 1
"""Number of the border between images and floor."""


class ImageRoom(QObject):
    """Gives pictures the width that their height fills, and the floor the rest.

    Both cameras stand one above the other. Where the user moves the border, it stays there,
    whatever is opened, until the cameras that are shown change: also from one start to the next.

    Attributes:
        moved: beside how many cameras the user moved the border; 0: it is where it fits.
    """

    def __init__(self, top: QSplitter, cameras: QSplitter, panels: QWidget) -> None:
        """`top` holds the images, the floor and the panels at the right; `cameras` the images."""
        super().__init__(top)
        self._top, self._cameras = top, cameras
        self._aspect = 0.0  # 0: the room is as the user left it
        self._count = 0
        self.moved = 0
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._fit)
        for watched in (top, panels):
            watched.installEventFilter(self)
        top.splitterMoved.connect(self._leave_it)

    def begin(self, aspect: float, count: int) -> None:
        """So many pictures are shown, so much wider than high."""
        self._count = count
        if self.moved != count:
            self.moved = 0
            self._aspect = aspect
            self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Follow the height of the pictures, and the panels, which take from their width."""
        resized = event.type() is QEvent.Type.Resize and self._aspect
        if resized or (event.type() is QEvent.Type.LayoutRequest and watched is self._top):
            self._soon.start()
        return super().eventFilter(watched, event)

    def _fit(self) -> None:
        self._widen_floor()
        if self._aspect:
            between = self._cameras.handleWidth() * (self._count - 1)
            each = (self._top.height() - between) / self._count
            most = (1 - _LEAST_FLOOR) * sum(self._top.sizes()[:2])
            self._give(round(min(self._aspect * each, most)))

    def _give(self, width: int) -> None:
        cameras, floor, side = self._top.sizes()
        width = min(width, cameras + floor - self._least(_FLOOR))
        if width > 0 and cameras + floor > width:
            self._top.setSizes([width, cameras + floor - width, side])

    def _widen_floor(self) -> None:
        """Give the floor, and panels opened below it, what they need of what the others do not."""
        sizes = self._top.sizes()
        least = [self._least(at) for at in range(len(sizes))]
        for other in (_IMAGES, _SIDE):
            short, spare = least[_FLOOR] - sizes[_FLOOR], sizes[other] - least[other]
            if short > 0 and spare > 0:
                sizes[_FLOOR] += min(short, spare)
                sizes[other] -= min(short, spare)
        if sizes != self._top.sizes():
            self._top.setSizes(sizes)

    def _least(self, at: int) -> int:
        part = self._top.widget(at)
        if part is None:
            return 0
        return max(part.minimumSizeHint().width(), part.minimumWidth())

    def _leave_it(self, _: int, border: int) -> None:
        """The user moved a border; the one between cameras and floor is where they want it."""
        if border == _IMAGES_END:
            self._aspect, self.moved = 0.0, self._count
