"""Where to look next: the queue of review items, what to say of the current one, how it gets on."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.icons import IconButton
from app.core.look.theme import scaled_font
from app.core.widgets.command_list import native_keys
from app.core.widgets.parts import Panel, bring_into_view, quiet
from app.core.widgets.queue_list import ReviewDelegate, ReviewModel, row_height
from app.features.review.queue_view import FewLines, QueueView
from app.features.review.scene import Order, ReviewScene
from app.features.review.strip_view import StripView

_ROWS = 2  # seen at least
_SIGNS = {"Backspace": "\u232b", "Return": "\u21b5"}
"""Keys with a sign of their own, where there is little room."""


class ReviewPanel(Panel):
    """Draws a :class:`ReviewScene`; without anything to list it takes a few lines only.

    Signals:
        item_chosen(object): the key of a review item that was clicked.
        kind_chosen(str): "" for all. order_chosen(str): the value of an `Order`.
        search_asked(): tracks that no tracker made are to be looked through all the same.
        playing_chosen(bool): whether a stretch is played as soon as it is jumped to.
    """

    item_chosen = Signal(object)
    kind_chosen = Signal(str)
    order_chosen = Signal(str)
    playing_chosen = Signal(bool)
    search_asked = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Review queue"), parent)
        self._scene = ReviewScene()
        self._model = ReviewModel(self)
        self._build_heading()
        self._build_list()
        self._build_choices()
        self._title = quiet("", self)
        self._title.setWordWrap(True)
        self._text = quiet("", self, "faint")
        self._text.setWordWrap(True)
        self._ask = QPushButton(tr("Look for review items"), self)
        self._ask.clicked.connect(self.search_asked)
        self._also = FewLines(self)
        self._also.setFont(scaled_font(self.font(), 0.88))
        self.strip = StripView(self)
        self.learned = quiet("", self)
        self._doing = quiet("", self, "faint")
        self._meter = quiet("", self, "faint")
        for label in (self.learned, self._doing, self._meter):
            label.setFont(scaled_font(self.font(), 0.88))
            label.setWordWrap(True)
        self._decisions = QHBoxLayout()
        self._decisions.setSpacing(6)
        self._tools: list[QToolButton] = []
        body = QVBoxLayout()
        body.setSpacing(4)
        body.addLayout(self._choices)
        body.addWidget(self._list, 1)
        body.addLayout(self._decisions)  # right below the rows: in sight in a low place, too
        body.addWidget(self._also)
        body.addWidget(self.strip)
        body.addWidget(self.learned)
        for words in (self._title, self._text, self._ask, self._doing, self._meter):
            body.addWidget(words)
        self._body = body
        self.layout_body(body)
        self.show_scene(ReviewScene())

    def _build_heading(self) -> None:
        self._left = quiet("", self)
        self._plays = IconButton("play", tr("Play each item's range when going to it"), "", self)
        self._plays.setCheckable(True)
        self._plays.clicked.connect(self.playing_chosen)
        self.add_to_heading(self._left)
        self.add_to_heading(self._plays)

    def _build_list(self) -> None:
        self._list = QueueView(self)
        self._list.setModel(self._model)
        self._list.setItemDelegate(ReviewDelegate(self._list))
        self._list.setAccessibleName(tr("Review items"))
        self._list.setProperty("rows", True)
        self._list.setUniformItemSizes(True)
        self._list.setMouseTracking(True)
        self._list.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # N and P walk it from everywhere
        self._list.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.setMinimumHeight(
            _ROWS * row_height(self._list.font(), ReviewDelegate.lower_lines)
        )
        self._list.clicked.connect(
            lambda index: self.item_chosen.emit(self._model.item(index.row()).key)
        )

    def _build_choices(self) -> None:
        self._choices = QHBoxLayout()
        self._kinds = self._combo(tr("Kind of review item"))
        self._kinds.activated.connect(lambda at: self.kind_chosen.emit(self._kinds.itemData(at)))
        self._orders = self._combo(tr("Order of the queue"))
        self._orders.addItem(tr("by worth"), Order.WORTH.value)
        self._orders.addItem(tr("by time"), Order.TIME.value)
        worth = tr("Worth: likelihood of an error, times its size")
        self._orders.setItemData(0, worth, Qt.ItemDataRole.ToolTipRole)
        self._orders.activated.connect(lambda at: self.order_chosen.emit(self._orders.itemData(at)))
        self._choices.addWidget(self._kinds, 1)
        self._choices.addWidget(self._orders, 1)

    def _combo(self, name: str) -> QComboBox:
        combo = QComboBox(self)
        combo.setAccessibleName(name)
        combo.setToolTip(name)
        combo.setFont(scaled_font(self.font(), 0.92))
        combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        combo.setMinimumContentsLength(6)
        combo.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        return combo

    def set_actions(self, actions: Sequence[tuple[QAction, str]]) -> None:
        """Offer the window's own commands on the current review item, each with a short word."""
        for action, word in actions:
            tool = QToolButton(self)
            tool.setAccessibleName(action.text())
            tool.setProperty("tight", True)
            tool.setProperty("outlined", True)
            tool.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            tool.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            tool.clicked.connect(action.trigger)
            follow = partial(_follow, tool, action, word)
            action.changed.connect(follow)
            follow()
            self._tools.append(tool)
            self._decisions.addWidget(tool, 1)
            tool.setVisible(bool(self._scene.items))
        # As wide without decisions: nothing beside the panel moves when the first ones come.
        for tool in self._tools:
            tool.ensurePolished()
        widths = [tool.minimumSizeHint().width() for tool in self._tools]
        self._body.addStrut(sum(widths) + self._decisions.spacing() * max(len(widths) - 1, 0))

    def show_scene(self, scene: ReviewScene) -> None:
        """Show the queue as it stands."""
        before, self._scene = self._scene, scene
        listed = bool(scene.items)
        self._model.take(scene.items)
        self._left.setText(tr("{0} left").format(scene.left) if scene.left else "")
        self._plays.setChecked(scene.plays)
        self._plays.setVisible(bool(scene.left))
        self._show_kinds(scene)
        self._orders.setCurrentIndex(self._orders.findData(scene.order.value))
        for widget in (self._list, self._kinds, self._orders, *self._tools):
            widget.setVisible(listed)
        if listed and not before.items:  # a hidden list keeps its place, that of another session
            self._list.scrollToTop()
        self._also.setText(scene.also)
        self._also.setVisible(listed and bool(scene.also))  # else the rows have its room
        self.strip.setVisible(listed and scene.current >= 0)
        self._say(self._title, "" if listed else scene.title)
        self._say(self._text, "" if listed else scene.text)
        self._ask.setVisible(scene.waits)
        self._say(self.learned, scene.learned if listed else "")
        self.learned.setToolTip(scene.all_learned)
        self._say(self._doing, scene.doing)
        self._say(self._meter, scene.meter)
        self._meter.setToolTip(scene.counted)
        self._meter.setAccessibleDescription(scene.counted)
        self.keep_low(not listed)
        self._select(scene.current)

    def _say(self, label: QLabel, text: str) -> None:
        label.setText(text)
        label.setVisible(bool(text))

    def minimumSizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """So high that rows, buttons and all words have room at the width there is."""
        least, body = super().minimumSizeHint(), self.layout()
        if body is not None and body.hasHeightForWidth():
            least.setHeight(max(least.height(), body.minimumHeightForWidth(self.width())))
        return least

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Words wrap at another place: another height is the least."""
        super().resizeEvent(event)
        if event.oldSize().width() != event.size().width():
            self.updateGeometry()

    def _select(self, row: int) -> None:
        if row < 0:
            self._list.clearSelection()
            return
        index = self._model.index(row)
        another = index != self._list.currentIndex() or not self._list.selectedIndexes()
        self._list.setCurrentIndex(index)
        self._list.scrollTo(index)
        if another and not self._list.underMouse():  # what is pointed at stays where it is
            for widget in (*self._tools[:1], self._list):
                bring_into_view(widget)

    def _show_kinds(self, scene: ReviewScene) -> None:
        titles = [(tr("All kinds"), "")]
        titles += [(f"{one.title}  {one.count}", one.kind) for one in scene.kinds]
        combo = self._kinds
        before = [(combo.itemText(at), combo.itemData(at)) for at in range(combo.count())]
        if titles != before:
            combo.clear()
            for title, kind in titles:
                combo.addItem(title, kind)
        combo.setCurrentIndex(max(0, combo.findData(scene.kind)))


def _follow(tool: QToolButton, action: QAction, word: str) -> None:
    """Show the action's key behind the word, and whether and why it can be done."""
    key = native_keys(action.shortcut().toString())
    tool.setText(f"{word}  {_SIGNS.get(key, key)}".rstrip())
    tool.setEnabled(action.isEnabled())
    tool.setToolTip(action.toolTip())
