"""How wide both eyes' pictures are, one above the other: no wider than they fill."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QSplitter

_LEAST_FLOOR = 0.4
"""Of what eyes and floor have together the floor keeps so much, however wide the pictures are."""
_EYES_END = 1
"""Number of the border between eyes and floor."""


class EyesRoom(QObject):
    """Gives the floor what the pictures of both eyes leave empty at their sides.

    The pictures have the usual room again once only one is shown. Where the user moves the border,
    it stays there, whatever is opened, until the eyes that are shown change.

    Attributes:
        moved: the user moved the border while both eyes were shown.
    """

    def __init__(self, top: QSplitter, eyes: QSplitter) -> None:
        """`top` holds the eyes, the floor, and what stands at the side; `eyes` the two pictures."""
        super().__init__(top)
        self._top, self._eyes = top, eyes
        self._aspect = 0.0  # 0: the room is as the user left it
        self._usual: list[int] = []
        self.moved = False
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._fit)
        top.installEventFilter(self)
        top.splitterMoved.connect(self._leave_it)

    def begin(self, aspect: float) -> None:
        """Both pictures are shown, so much wider than high."""
        if not self._usual:
            self._usual = self._top.sizes()
        if self.moved:
            return
        self._aspect = aspect
        self._fit()

    def end(self) -> None:
        """One picture has the room it had."""
        if self._usual and self._aspect:
            share = self._usual[0] / max(1, sum(self._usual[:2]))
            self._give(round(share * sum(self._top.sizes()[:2])))
        self._usual, self._aspect, self.moved = [], 0.0, False

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Follow the height of the pictures."""
        if event.type() is QEvent.Type.Resize and self._aspect:
            self._soon.start()
        return super().eventFilter(watched, event)

    def _fit(self) -> None:
        if self._aspect:
            each = (self._top.height() - self._eyes.handleWidth()) / 2
            most = (1 - _LEAST_FLOOR) * sum(self._top.sizes()[:2])
            self._give(round(min(self._aspect * each, most)))

    def _give(self, width: int) -> None:
        eyes, floor, side = self._top.sizes()
        if width > 0 and eyes + floor > width:
            self._top.setSizes([width, eyes + floor - width, side])

    def _leave_it(self, _: int, border: int) -> None:
        """The user moved a border; the one between eyes and floor is where they want it."""
        if border != _EYES_END:
            return
        self._aspect, self.moved = 0.0, bool(self._usual)
