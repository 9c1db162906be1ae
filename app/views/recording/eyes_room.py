"""How wide the pictures of the eyes are: no wider than they fill."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QSplitter

_LEAST_FLOOR = 0.4
"""Of what eyes and floor have together the floor keeps so much, however wide the pictures are."""
_EYES_END = 1
"""Number of the border between eyes and floor."""


class EyesRoom(QObject):
    """Gives pictures the width that their height fills, and the floor the rest.

    Both eyes stand one above the other. Where the user moves the border, it stays there, whatever
    is opened, until the eyes that are shown change: also from one start to the next.

    Attributes:
        moved: beside how many eyes the user moved the border; 0: it is where it fits.
    """

    def __init__(self, top: QSplitter, eyes: QSplitter) -> None:
        """`top` holds the eyes, the floor, and what stands at the side; `eyes` the pictures."""
        super().__init__(top)
        self._top, self._eyes = top, eyes
        self._aspect = 0.0  # 0: the room is as the user left it
        self._count = 0
        self.moved = 0
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._fit)
        top.installEventFilter(self)
        top.splitterMoved.connect(self._leave_it)

    def begin(self, aspect: float, count: int) -> None:
        """So many pictures are shown, so much wider than high."""
        self._count = count
        if self.moved != count:
            self.moved = 0
            self._aspect = aspect
            self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Follow the height of the pictures."""
        if event.type() is QEvent.Type.Resize and self._aspect:
            self._soon.start()
        return super().eventFilter(watched, event)

    def _fit(self) -> None:
        if self._aspect:
            between = self._eyes.handleWidth() * (self._count - 1)
            each = (self._top.height() - between) / self._count
            most = (1 - _LEAST_FLOOR) * sum(self._top.sizes()[:2])
            self._give(round(min(self._aspect * each, most)))

    def _give(self, width: int) -> None:
        eyes, floor, side = self._top.sizes()
        if width > 0 and eyes + floor > width:
            self._top.setSizes([width, eyes + floor - width, side])

    def _leave_it(self, _: int, border: int) -> None:
        """The user moved a border; the one between eyes and floor is where they want it."""
        if border == _EYES_END:
            self._aspect, self.moved = 0.0, self._count
