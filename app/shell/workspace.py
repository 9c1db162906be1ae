"""Everything on the window's page for an open recording, laid out."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from app.core.drawing.canvas import Canvas
from app.core.drawing.surfaces import Surfaces
from app.core.feature import FeaturePanel, Place
from app.core.i18n import tr
from app.core.look.theme import scaled_font
from app.core.scenes import Side
from app.core.widgets.gripped_splitter import GrippedSplitter
from app.core.widgets.parts import Panel
from app.core.widgets.user_settings import UserSettings
from app.features.comparison.compare_panel import ComparePanel
from app.features.comparison.differences_scene import DifferencesScene
from app.features.comparison.panel import DifferencesPanel
from app.features.correction.panel import EditPanel
from app.features.correction.track_panel import TrackPanel
from app.features.labelling.panel import LabellingPanel
from app.features.pictures.camera_switch import CameraSwitch
from app.features.pictures.overhead_view import OverheadView
from app.features.pictures.picture_view import PictureView
from app.features.playback.transport import TransportBar
from app.features.review.panel import ReviewPanel
from app.features.timeline.panel import TimelineView
from app.shell.below_floor import BelowFloor
from app.shell.features import FEATURES
from app.shell.image_room import ImageRoom
from app.shell.layout_shares import LayoutShares
from app.shell.pane_keys import PaneKeys, Panes
from app.shell.pane_ring import PaneRing
from app.shell.panel_column import PanelColumn
from app.shell.panel_docks import Dock, PanelDocks

PanelT = TypeVar("PanelT", bound=FeaturePanel)
_PANEL_LETTERS = 55
_LOW_LINES = 36
"""A page of fewer lines of text is low."""


class Workspace(QWidget):
    """The pictures, the floor, the panels, transport and timeline.

    Signals: `setup_asked()`: the floor is unknown, and is to be set up.
    """

    setup_asked = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.left = PictureView(Side.LEFT, self)
        self.right = PictureView(Side.RIGHT, self)
        self.camera_switch = CameraSwitch(self)
        self.overhead = OverheadView(self)
        self.review = ReviewPanel(self)
        self.card = TrackPanel(self)
        self.preview = EditPanel(self)
        self.labelling = LabellingPanel(self)
        self.compare = ComparePanel(self)
        self.differences = DifferencesPanel(self)
        self.transport = TransportBar(self)
        self.timeline = TimelineView(self)
        self.surfaces = Surfaces(self.left, self.right, self.overhead)
        self._shares = LayoutShares()
        self.panels: dict[str, FeaturePanel] = {}
        self._floor_known = self._floor_wanted = True
        for feature in FEATURES:
            if feature.panel is not None:
                panel = self.panels[feature.id] = feature.panel(self)
                self.timeline.area.stretch.changed.connect(panel.show_axis)
        self._lay_out()
        self._fit_places()
        self.messages: tuple[QWidget, ...] = ()
        self._ring = PaneRing(self)
        panes = Panes(self.left, self.panes, self._walked_lists, self._bring_forward)
        self.pane_keys = PaneKeys(panes, self._ring)

    def _lay_out(self) -> None:
        cameras = self._split("eyes", Qt.Orientation.Vertical, (self.left, self.right), (1, 1))
        below = BelowFloor(tr("Panels below the floor"), (), self)
        below.setObjectName("below floor")
        self._shared_places: tuple[BelowFloor, ...] = (below,)
        parts = (self.overhead, below)
        self._floor = self._split("floor and panels", Qt.Orientation.Vertical, parts, (5, 6))
        self._side = self._build_side()
        self._dock_panels(below)
        views = (cameras, self._floor, self._side)
        top = self._split("top", Qt.Orientation.Horizontal, views, (9, 10, 6))
        self._image_room = ImageRoom(top, *views, lambda: below.needed_px)
        upper = QWidget(self)
        column = _unspaced(upper)
        column.addWidget(top, 1)
        self.transport_line = self._build_transport_line()
        column.addWidget(self.transport_line)
        drag = tr("Drag to make the timeline higher or lower")
        border = GrippedSplitter(Qt.Orientation.Vertical, drag, self)
        whole = self._filled("whole", border, (upper, self.timeline), (3, 1))
        _unspaced(self).addWidget(whole)

    def _dock_panels(self, below: BelowFloor) -> None:
        """Put every panel where it stands at first."""
        docks = {Place.SIDE: Dock.SIDE, Place.BELOW_FLOOR: Dock.BELOW}
        panels: dict[str, tuple[Panel, Dock]] = {
            "review": (self.review, Dock.SIDE),
            "card": (self.card, Dock.SIDE),
        }
        for feature in FEATURES:
            if feature.id in self.panels:
                panels[feature.id] = (self.panels[feature.id], docks[feature.place])
        self.docks = PanelDocks(panels, self._column, below, self)
        self._keep_shares("side", self._column, (11, *(5 for _ in range(1, self._column.count()))))
        self.docks.changed.connect(self._fit_places)
        for widget in (self.preview, self.labelling, self.compare, self.differences):
            widget.installEventFilter(self)

    def _build_side(self) -> QWidget:
        """The panels, and above them what is being edited, labelled or compared.

        An edit that waits takes room from the panels alone: the pictures stay as large as before.
        """
        self._panels = self._scrolled_panels()
        self.differences.setMinimumWidth(self._panels.minimumSizeHint().width())
        # As wide as the panels, and as high as its words need at that width.
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        self.preview.setSizePolicy(policy)
        side = QWidget(self)
        column = _unspaced(side)
        column.addWidget(self.preview)
        at_work = (self.labelling, self.compare)
        shared = BelowFloor(tr("Labelling and comparison"), at_work, self)
        shared.setObjectName("labelling and comparison")
        self._shared_places = (*self._shared_places, shared)
        column.addWidget(shared)
        column.addWidget(self._panels, 1)
        column.addWidget(self.differences, 1)
        return side

    def _scrolled_panels(self) -> PanelColumn:
        """On a low screen the panels scroll, so that they never make the window too high for it."""
        self._column = QSplitter(Qt.Orientation.Vertical, self)
        self._column.setChildrenCollapsible(False)
        least_px = _PANEL_LETTERS * self.fontMetrics().averageCharWidth()
        return PanelColumn(self._column, least_px, self)

    def _build_transport_line(self) -> QFrame:
        """Playback and, at its end, which cameras are shown: no picture is covered by a switch."""
        line = QFrame(self)
        line.setProperty("bar", True)
        line.setAccessibleName(self.transport.accessibleName())
        row = QHBoxLayout(line)
        row.setContentsMargins(0, 0, 12, 0)
        row.addWidget(self.transport, 1)
        self.setup = QPushButton(tr("Set up this recording"), line)
        self.setup.setFont(scaled_font(self.font(), 0.92))
        self.setup.setToolTip(tr("Say where the floor is, to see people from above"))
        self.setup.clicked.connect(self.setup_asked)
        self.setup.hide()
        row.addWidget(self.setup, 0, Qt.AlignmentFlag.AlignVCenter)
        row.addSpacing(8)
        row.addWidget(self.camera_switch, 0, Qt.AlignmentFlag.AlignVCenter)
        return line

    def _split(
        self,
        name: str,
        orientation: Qt.Orientation,
        parts: tuple[QWidget, ...],
        shares: tuple[int, ...],
    ) -> QSplitter:
        return self._filled(name, QSplitter(orientation, self), parts, shares)

    def _filled(
        self,
        name: str,
        splitter: QSplitter,
        parts: tuple[QWidget, ...],
        shares: tuple[int, ...],
    ) -> QSplitter:
        splitter.setChildrenCollapsible(False)
        for part in parts:
            splitter.addWidget(part)
        self._keep_shares(name, splitter, shares)
        return splitter

    def _keep_shares(self, name: str, splitter: QSplitter, shares: tuple[int, ...]) -> None:
        """Share a splitter's room among its parts, from one start to the next."""
        for at, share in enumerate(shares):
            splitter.setStretchFactor(at, share)
        self._shares.add(name, splitter, shares)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """The page is higher or lower."""
        super().resizeEvent(event)
        self.preview.set_terse(self.height() < _LOW_LINES * self.fontMetrics().lineSpacing())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """An edit, labels or a comparison need the column at the right."""
        if event.type() in (QEvent.Type.ShowToParent, QEvent.Type.HideToParent):
            self._fit_places()
        return super().eventFilter(watched, event)

    def _fit_places(self) -> None:
        """Show the column at the right and the floor's where something stands in them."""
        compared = not self.differences.isHidden()
        at_work = (self.preview, self.labelling, self.compare)
        self._panels.setVisible(self.docks.any_open(Dock.SIDE) and not compared)
        self._side.setVisible(
            compared
            or self.docks.any_open(Dock.SIDE)
            or any(not widget.isHidden() for widget in at_work)
        )
        self.overhead.setVisible(self._floor_known and self._floor_wanted)
        self._floor.setVisible(not self.overhead.isHidden() or self.docks.any_open(Dock.BELOW))

    @property
    def floor_wanted(self) -> bool:
        """Whether the overhead view is open; it is shown where the floor is known."""
        return self._floor_wanted

    @floor_wanted.setter
    def floor_wanted(self, wanted: bool) -> None:
        self._floor_wanted = wanted
        self._fit_places()

    def know_floor(self, known: bool) -> None:
        """Whether the recording says where the floor is: there is no overhead view without."""
        self._floor_known = known
        self.setup.setHidden(known)
        self._fit_places()

    def reset_layout(self) -> None:
        """Lay all out as at the first start."""
        self.docks.reset()
        self._shares.reset()
        self._image_room.fit_again()

    def of(self, kind: type[PanelT]) -> PanelT:
        """The feature's panel of this kind. Raises LookupError where there is none."""
        for panel in self.panels.values():
            if isinstance(panel, kind):
                return panel
        raise LookupError(f"no panel is a {kind.__name__}")

    def show_differences(self, scene: DifferencesScene | None) -> None:
        """Show a comparison in the place of the panels, or the panels again."""
        self.differences.show_scene(scene)
        self._fit_places()

    def show_cameras(self, mode: str, aspect: float, stereo: bool) -> None:
        """Lay out for "left", "both" or "anaglyph"; pictures are `aspect` times wider than high."""
        both = mode == "both" and stereo
        self.right.setVisible(both)
        self.left.set_alone(not stereo)
        self._image_room.begin(aspect, 2 if both else 1)
        self.camera_switch.show_scene(mode, stereo)
        self.camera_switch.setVisible(stereo)

    @property
    def canvases(self) -> tuple[Canvas, ...]:
        """The pictures and the floor."""
        return self.left, self.right, self.overhead

    def show_whole(self) -> None:
        """Show all of the pictures and of the floor, and keep doing so."""
        for view in self.canvases:
            view.fit()

    def take_typed(self) -> None:
        """Take what is being typed into the card as if its field had been left."""
        typed_into = QApplication.focusWidget()
        if typed_into is not None and self.card.isAncestorOf(typed_into):
            typed_into.clearFocus()

    def panes(self) -> tuple[QWidget, ...]:
        """The parts that are open, in the order in which F6 walks them.

        Pictures, floor, panels below it, edit that waits, labelling, compared, queue, card, panels
        below them, playback, timeline, message.
        """
        below, side = self.docks.at(Dock.BELOW), self.docks.at(Dock.SIDE)
        views, windows = (self.left, self.right, self.overhead), self.docks.at(Dock.WINDOW)
        above = (self.preview, self.labelling, self.compare)
        lower = (self.differences, self.transport_line, self.timeline, *self.messages)
        every = (*views, *below, *above, *side, *windows, *lower)
        return tuple(one for one in every if one.isVisible() or self._is_behind_another(one))

    def _is_behind_another(self, pane: QWidget) -> bool:
        return any(place.isVisible() and place.holds_open(pane) for place in self._shared_places)

    def _walked_lists(self) -> tuple[QWidget, ...]:
        return (*self.docks.panels.values(), self.differences)

    def _bring_forward(self, pane: QWidget) -> None:
        for place in self._shared_places:
            place.bring_forward(pane)

    def remember(self, remembered: UserSettings) -> None:
        """Keep how the parts are laid out."""
        remembered.set_text("workspace/eyes moved", str(self._image_room.moved or ""))
        remembered.set_text("workspace/side moved", "yes" if self._image_room.side_moved else "")
        self._shares.remember(remembered, self.screen())
        self.docks.remember(remembered)
        remembered.set_text("panels/overhead closed", "" if self._floor_wanted else "closed")
        self.timeline.area.controls.remember(remembered)

    def restore(self, remembered: UserSettings) -> None:
        """Lay the parts out as they were."""
        self.docks.restore(remembered)
        self.floor_wanted = not remembered.text("panels/overhead closed")
        self._shares.restore(remembered, self.screen())
        beside = remembered.text("workspace/eyes moved")
        self._image_room.moved = {"1": 1, "2": 2}.get(beside, 0)
        self._image_room.side_moved = bool(remembered.text("workspace/side moved"))
        self.timeline.area.controls.restore(remembered)


def _unspaced(widget: QWidget) -> QVBoxLayout:
    """A column that fills a widget, nothing between its parts."""
    column = QVBoxLayout(widget)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(0)
    return column
