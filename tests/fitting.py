"""Measures whether what a widget says fits into it: texts that are cut off are listed."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QCheckBox,
    QComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMenuBar,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QStyle,
    QStyleOptionComboBox,
    QTabBar,
    QToolButton,
    QWidget,
)

from app.core.widgets.eliding_label import ElidingLabel
from app.core.widgets.eliding_list import ElidingList
from app.features.welcome.welcome_parts import ChoiceButton

_SLACK_PX = 1
"""Letters lean out of their own width by no more."""


def cut_off(window: QWidget, looked_at: Callable[[QWidget], bool] = lambda _: True) -> list[str]:
    """What is cut off of the words of all widgets that are seen in a window, with where.

    looked_at: whether a widget counts.
    """
    found = []
    for widget in filter(looked_at, (window, *window.findChildren(QWidget))):
        if widget.isVisible() and widget.window() is window and not widget.size().isEmpty():
            for text, why in _cut_off(widget):
                found.append(f"{type(widget).__name__} {_place(widget)} {text!r}: {why}")
    return found


def _cut_off(widget: QWidget) -> Iterator[tuple[str, str]]:
    if isinstance(widget, ChoiceButton):
        needed = widget.sizeHint().height()
        if needed > widget.height():
            yield widget.accessibleName(), f"{needed} px high, room for {widget.height()}"
    elif isinstance(widget, QLabel):
        yield from _of_label(widget)
    elif isinstance(widget, (QPushButton, QToolButton, QCheckBox, QRadioButton)):
        yield from _of_button(widget)
    elif isinstance(widget, QComboBox):
        yield from _of_choice(widget)
    elif isinstance(widget, QTabBar):
        for at in range(widget.count()):
            yield from _narrow(
                widget.tabText(at), widget.tabSizeHint(at).width(), widget.tabRect(at).width()
            )
    elif isinstance(widget, QHeaderView):
        yield from _of_head(widget)
    elif isinstance(widget, QMenuBar):
        yield from _of_menu_bar(widget)
    elif isinstance(widget, QGroupBox):
        needed = widget.fontMetrics().horizontalAdvance(widget.title())
        yield from _narrow(widget.title(), needed, widget.width())
    elif isinstance(widget, QLineEdit) and not widget.text():
        margins = widget.textMargins()
        room = widget.width() - margins.left() - margins.right() - 4
        needed = widget.fontMetrics().horizontalAdvance(widget.placeholderText())
        yield from _narrow(widget.placeholderText(), needed, room)


def _narrow(text: str, needed: float, room: float) -> Iterator[tuple[str, str]]:
    if text and needed > room + _SLACK_PX:
        yield text, f"{needed:.0f} px wide, room for {room:.0f}"


def _of_label(label: QLabel) -> Iterator[tuple[str, str]]:
    """A label that wraps is to be as high as its lines; any other as wide as its words."""
    text, room = label.text(), label.contentsRect()
    if not text or label.pixmap().width() or isinstance(label, ElidingLabel):
        return
    if label.buddy() is not None:
        text = text.replace("&", "")
    margin = 2 * label.margin()
    if label.wordWrap():
        needed = label.fontMetrics().boundingRect(
            QRect(0, 0, room.width() - margin, 1 << 20), Qt.TextFlag.TextWordWrap, text
        )
        if needed.height() > room.height() - margin + 2:
            yield text, f"{needed.height()} px high, room for {room.height() - margin}"
        yield from _narrow(text, needed.width(), room.width() - margin)
        return
    widest = max(map(label.fontMetrics().horizontalAdvance, text.split("\n")))
    yield from _narrow(text, widest, room.width() - margin)
    high = label.fontMetrics().height() * (text.count("\n") + 1)
    if high > room.height() + 2:
        yield text, f"{high} px high, room for {room.height()}"


def _of_button(button: QAbstractButton) -> Iterator[tuple[str, str]]:
    icon_only = (
        isinstance(button, QToolButton)
        and button.toolButtonStyle() == Qt.ToolButtonStyle.ToolButtonIconOnly
        and not button.icon().isNull()
    )
    if icon_only or not button.text():
        return
    letters = button.fontMetrics().horizontalAdvance(button.text().replace("&", ""))
    # A style gives a button more around its words than it needs.
    room = button.width() - (button.iconSize().width() if not button.icon().isNull() else 0)
    yield from _narrow(button.text(), letters, room)
    if isinstance(button, (QCheckBox, QRadioButton)):
        yield from _narrow(button.text(), button.sizeHint().width(), button.width())
    if button.fontMetrics().height() > button.height() + 2:
        yield button.text(), f"low: {button.height()} px"


def _of_choice(choice: QComboBox) -> Iterator[tuple[str, str]]:
    """What is chosen; a list that opens is as wide as it needs."""
    if choice.isEditable() or isinstance(choice, ElidingList):  # which shows the end by a tooltip
        return
    option = QStyleOptionComboBox()
    choice.initStyleOption(option)
    room = choice.style().subControlRect(
        QStyle.ComplexControl.CC_ComboBox,
        option,
        QStyle.SubControl.SC_ComboBoxEditField,
        choice,
    )
    text = choice.currentText()
    yield from _narrow(text, choice.fontMetrics().horizontalAdvance(text), room.width())


def _of_head(head: QHeaderView) -> Iterator[tuple[str, str]]:
    if head.orientation() is not Qt.Orientation.Horizontal or head.model() is None:
        return
    for at in range(head.count()):
        text = head.model().headerData(at, Qt.Orientation.Horizontal)
        if text and not head.isSectionHidden(at):
            needed = head.fontMetrics().horizontalAdvance(str(text))
            yield from _narrow(str(text), needed, head.sectionSize(at))


def _of_menu_bar(bar: QMenuBar) -> Iterator[tuple[str, str]]:
    more = bar.findChild(QToolButton, "qt_menubar_ext_button")
    if more is not None and more.isVisible():  # it opens what has no room
        return
    corner = bar.cornerWidget()
    end = corner.x() if corner is not None and corner.isVisible() else bar.width()
    for action in bar.actions():
        place = bar.actionGeometry(action)
        if place.isEmpty() or place.right() > end:
            yield action.text(), f"ends at {place.right()}, the bar at {end}"


def beyond(window: QWidget) -> list[str]:
    """Buttons and labels that lie outside of what is seen of their window."""
    found = []
    for widget in window.findChildren(QWidget):
        if not isinstance(widget, (QAbstractButton, QLabel)) or not widget.isVisible():
            continue
        if widget.window() is not window or _scrolls(widget):
            continue
        place = QRect(widget.mapTo(window, QPoint()), widget.size())
        if not window.rect().adjusted(-1, -1, 1, 1).contains(place):
            found.append(f"{type(widget).__name__} {widget.text()!r}: {place} of {window.size()}")
    return found


def _scrolls(widget: QWidget) -> bool:
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, (QScrollArea, QAbstractItemView)):
            return True
        around = around.parentWidget()
    return False


def _place(widget: QWidget) -> str:
    """The widget's class and name, and those of what it stands in."""
    names = []
    around: QWidget | None = widget
    while around is not None and len(names) < 3:
        around = around.parentWidget()
        if around is not None and (around.objectName() or type(around) is not QWidget):
            names.append(around.objectName() or type(around).__name__)
    return "in " + " of ".join(names)
