"""How wide the images of the cameras are: at least half of the window, and what they fill."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import QSplitter, QWidget

_LEAST_FLOOR = 0.4
"""Least share of the width of images and floor that the floor keeps beyond the images' half."""
_IMAGES, _IMAGES_BESIDE_PANELS = 0.5, 0.37
"""Least share of the images in the width of all; beside a panel that needs more room."""
_PANELS = 0.23
"""Share of the panels at the right."""
_IMAGES_END = 1
"""Number of the border between images and floor."""

_OTHER_ROOM = frozenset(
    {
        QEvent.Type.Resize,
        QEvent.Type.ShowToParent,
        QEvent.Type.HideToParent,
        QEvent.Type.LayoutRequest,
    }
)


class ImageRoom(QObject):
    """Gives images the width that their height fills, at least half of all, and the floor the rest.

    Two cameras stand one above the other or side by side, however they are larger. Where the user
    moves the border, it stays there, whatever is opened, until the cameras that are shown change:
    also from one start to the next.

    Attributes:
        moved: beside how many cameras the user moved the border; 0: it is where it fits.
        side_moved: whether the user moved the border of the panels at the right.
    """

    def __init__(
        self,
        top: QSplitter,
        cameras: QSplitter,
        floor: QWidget,
        panels: QWidget,
        needed_px: Callable[[], int],
    ) -> None:
        """`top` holds images, floor, and panels at the right; `cameras` the images.

        needed_px: the width that a panel below the floor needs.
        """
        super().__init__(top)
        self._top, self._cameras, self._floor, self._panels = top, cameras, floor, panels
        self._needed_px = needed_px
        self._aspect = 0.0
        self._count = 0
        self.moved, self.side_moved = 0, False
        self._share = 0.0
        """Of the images, where the user moved their border; 0: as it is now."""
        self._soon = QTimer(self, singleShot=True, interval=0)
        self._soon.timeout.connect(self._fit)
        for watched in (top, floor, panels):
            watched.installEventFilter(self)
        top.splitterMoved.connect(self._leave_it)

    def begin(self, aspect: float, count: int) -> None:
        """So many images are shown, so much wider than high."""
        self._count, self._aspect = count, aspect
        if self.moved != count:
            self.moved, self._share = 0, 0.0
        self._fit()

    def fit_again(self) -> None:
        """Forget where the user moved the border."""
        self.moved, self.side_moved = 0, False
        self._fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Follow the height of the images, and what takes from their width."""
        if event.type() in _OTHER_ROOM and self._aspect:
            self._soon.start()
        return super().eventFilter(watched, event)

    def _fit(self) -> None:
        if not self._aspect or not self._top.height():
            return
        room = sum(self._top.sizes()) - self._side_px()
        if self.moved:
            width = self._given()
            self._turn(width)
            self._give(width, room)
            return
        if self._floor.isHidden():
            self._turn(room)
            self._give(room, room)
            return
        width, beside = self._top.width(), room - self._needed_px()
        least = min(round(_IMAGES * width), max(round(_IMAGES_BESIDE_PANELS * width), beside))
        most = max(least, min(round((1 - _LEAST_FLOOR) * room), beside))
        wide = {
            across: max(least, min(most, self._filled(across)))
            for across in (False, True)[: self._count]
        }
        across = self._larger(wide)
        self._orient(across)
        self._give(wide[across], room)

    def _given(self) -> int:
        """The width of the images that the user gave them: their share, in a wider window, too."""
        sizes = self._top.sizes()
        self._share = self._share or sizes[0] / max(1, sum(sizes))
        return round(self._share * sum(sizes))

    def _side_px(self) -> int:
        """The width of the panels at the right: their share, unless the user gave them another."""
        if self._panels.isHidden():
            return 0
        if self.side_moved:
            return self._top.sizes()[-1]
        return max(self._panels.minimumSizeHint().width(), round(_PANELS * self._top.width()))

    def _turn(self, width: int) -> None:
        """Lay two images out anew in the width that the user gave them."""
        self._orient(self._larger(dict.fromkeys((False, True)[: self._count], width)))

    def _filled(self, across: bool) -> int:
        """The width that images fill at the height there is, px."""
        between = self._cameras.handleWidth() * (self._count - 1)
        if across:
            return round(self._count * self._aspect * self._top.height()) + between
        return round(self._aspect * (self._top.height() - between) / self._count)

    def _larger(self, wide: dict[bool, int]) -> bool:
        """Whether images are larger side by side, in the widths they would have."""

        def image_px(across: bool) -> float:
            high = self._top.height() / (1 if across else self._count)
            return min(wide[across] / (self._count if across else 1), self._aspect * high)

        return max(wide, key=image_px)

    def _orient(self, across: bool) -> None:
        wanted = Qt.Orientation.Horizontal if across else Qt.Orientation.Vertical
        if self._cameras.orientation() is not wanted:
            self._cameras.setOrientation(wanted)
            self._cameras.setSizes([1, 1])

    def _give(self, width: int, room: int) -> None:
        """Give images this width of the room that the panels at the right leave."""
        sizes = [width, room - width, sum(self._top.sizes()) - room]
        if width > 0 and min(sizes) >= 0 and sizes != self._top.sizes():
            self._top.setSizes(sizes)

    def _leave_it(self, _: int, border: int) -> None:
        """The user moved a border, which stays where they want it."""
        if border != _IMAGES_END:
            self.side_moved = True
        if border == _IMAGES_END or self._floor.isHidden():
            self.moved, self._share = self._count, 0.0
            self._turn(self._given())
