"""What Qt's accessibility interface tells of a window, and where the Tab key leads in it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from PySide6.QtCore import QAbstractListModel, QPoint, QRect, Qt
from PySide6.QtGui import QAccessible, QAccessibleInterface
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QHeaderView,
    QLineEdit,
    QListView,
    QMenu,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QRadioButton,
    QScrollBar,
    QSplitterHandle,
    QTabBar,
    QTableView,
    QToolButton,
    QWidget,
)

Role, Text = QAccessible.Role, QAccessible.Text
_BUTTONS = (Role.Button, Role.ButtonMenu, Role.ButtonDropDown)
_ROLES: tuple[tuple[type[QWidget], tuple[QAccessible.Role, ...]], ...] = (
    (QCheckBox, (Role.CheckBox,)),
    (QRadioButton, (Role.RadioButton,)),
    (QPushButton, (*_BUTTONS, Role.CheckBox)),
    (QToolButton, (*_BUTTONS, Role.CheckBox, Role.RadioButton)),
    (QComboBox, (Role.ComboBox,)),
    (QAbstractSpinBox, (Role.SpinBox,)),
    (QScrollBar, (Role.ScrollBar,)),
    (QAbstractSlider, (Role.Slider,)),
    (QLineEdit, (Role.EditableText,)),
    (QPlainTextEdit, (Role.EditableText,)),
    (QTableView, (Role.Table,)),
    (QListView, (Role.List,)),
    (QTabBar, (Role.PageTabList,)),
    (QProgressBar, (Role.ProgressBar,)),
    (QSplitterHandle, (Role.Grip,)),
)
_MOST_CELLS = 40
_MOST_STEPS = 300
_LETTER = re.compile(r"\w")
_WHOLE = (QAbstractSpinBox, QComboBox, QTabBar)


def faults_of(window: QWidget) -> list[str]:
    """What is wrong with what a screen reader is told of all that is seen in a window."""
    found = []
    for interface, widget in interfaces(window):
        if _is_control(widget):
            place = f"{type(widget).__name__} {interface.text(Text.Name)!r} {_place(widget)}"
            found += [f"{place}: {fault}" for fault in _faults(interface, widget)]
    return found


def interfaces(window: QWidget) -> Iterator[tuple[QAccessibleInterface, QWidget]]:
    """The interface of each widget that is seen, as a screen reader walks to it."""
    waiting = [QAccessible.queryAccessibleInterface(window)]
    met = set()
    while waiting:
        interface = waiting.pop()
        widget = interface.object()
        if not isinstance(widget, QWidget) or id(widget) in met or isinstance(widget, QMenu):
            continue
        met.add(id(widget))
        if widget.isVisible() and widget.window() is window and not widget.size().isEmpty():
            yield interface, widget
            for at in range(interface.childCount()):
                child = interface.child(at)
                if child is not None and child.isValid():
                    waiting.append(child)


def menu_faults(menu: QMenu) -> list[str]:
    """Entries of a menu without a name, or whose tick is not told."""
    found = []
    interface = QAccessible.queryAccessibleInterface(menu)
    for at, action in enumerate(menu.actions()):
        child = interface.child(at)
        if action.isSeparator():
            continue
        if not _LETTER.search(child.text(Text.Name)):
            found.append(f"{menu.title()}: an entry without a name")
        if action.isCheckable() and bool(child.state().checked) != action.isChecked():
            found.append(f"{menu.title()}: {action.text()}: its tick is not told")
        if child.role() not in (Role.MenuItem, Role.PopupMenu):
            found.append(f"{menu.title()}: {action.text()}: {child.role()}")
    return found


def _is_control(widget: QWidget) -> bool:
    """Whether people act on it: of parts of a control the control itself speaks."""
    if widget.objectName().startswith("qt_") or _is_inner(widget):
        return False
    known = isinstance(widget, tuple(kind for kind, _ in _ROLES))
    return known or bool(widget.focusPolicy() & Qt.FocusPolicy.ClickFocus)


def _is_inner(widget: QWidget) -> bool:
    """What a control is made of: its line, its list, the area it scrolls, its head."""
    parent = widget.parentWidget()
    if isinstance(widget, QScrollBar):
        return not widget.accessibleName() and parent is not None
    if isinstance(parent, QAbstractItemView) and parent.viewport() is widget:
        return True
    corner = type(widget).__name__ == "QTableCornerButton"
    return corner or isinstance(parent, _WHOLE) or isinstance(widget, QHeaderView)


def _faults(interface: QAccessibleInterface, widget: QWidget) -> Iterator[str]:
    name = interface.text(Text.Name)
    if not _LETTER.search(name):
        yield "no name"
    expected = next((roles for kind, roles in _ROLES if isinstance(widget, kind)), None)
    if expected is not None and interface.role() not in expected:
        yield f"role {interface.role().name}"
    if bool(interface.state().disabled) == widget.isEnabled():
        yield "whether it is enabled is not told"
    yield from _state_faults(interface, widget)
    if isinstance(widget, QAbstractItemView):
        yield from _cell_faults(widget)


def _state_faults(interface: QAccessibleInterface, widget: QWidget) -> Iterator[str]:
    state = interface.state()
    if isinstance(widget, QAbstractButton) and widget.isCheckable():
        if not state.checkable:
            yield "that it can be checked is not told"
        if bool(state.checked) != widget.isChecked():
            yield "whether it is checked is not told"
    if isinstance(widget, QComboBox) and widget.currentIndex() >= 0:
        if interface.text(Text.Value) != widget.currentText():
            yield f"value {interface.text(Text.Value)!r}"
    elif isinstance(widget, QAbstractSpinBox):
        if not interface.text(Text.Value) and interface.valueInterface() is None:
            yield "no value"
    elif isinstance(widget, (QAbstractSlider, QProgressBar)):
        value = interface.valueInterface()
        if value is None or value.currentValue() != widget.value():
            yield "no value"
    elif isinstance(widget, QLineEdit) and interface.text(Text.Value) != widget.displayText():
        yield f"value {interface.text(Text.Value)!r}"


def _cell_faults(view: QAbstractItemView) -> Iterator[str]:
    """Rows of which nothing is told; a table's cell may be empty, a row of it not."""
    model = view.model()
    if model is None:
        return
    many = 1 if isinstance(model, QAbstractListModel) else model.columnCount()
    for row in range(min(model.rowCount(), _MOST_CELLS)):
        cells = [model.index(row, column) for column in range(many)]
        said = [one.data(Qt.ItemDataRole.AccessibleTextRole) or one.data() for one in cells]
        inside = [view.indexWidget(one) for one in cells]
        if not any(map(_said, said)) and not any(one and one.accessibleName() for one in inside):
            yield f"nothing is told of row {row}"


def _said(text: object) -> bool:
    return text is not None and bool(_LETTER.search(str(text)))


# the Tab key


def tab_order(window: QWidget) -> list[QWidget]:
    """Whom the Tab key leads to, one after the other, until it comes to the first one again."""
    window.activateWindow()
    first = _first_read(window)
    if first is None:
        return []
    first.setFocus(Qt.FocusReason.TabFocusReason)
    order: list[QWidget] = [_stop(first)]
    for _ in range(_MOST_STEPS):
        QTest.keyClick(window.focusWidget() or window, Qt.Key.Key_Tab)
        now = window.focusWidget()
        if now is None or _stop(now) is order[0]:
            break
        order.append(_stop(now))
    return order


def _first_read(window: QWidget) -> QWidget | None:
    """The control in the upper left corner, from where the order is read."""
    wanted = stops(window)
    if not wanted:
        return None
    top = min(_rect(window, one).center().y() for one in wanted if _rect(window, one).height())
    row = [one for one in wanted if _rect(window, one).top() <= top]
    return min(row, key=lambda one: _rect(window, one).left())


def stops(window: QWidget) -> list[QWidget]:
    """The controls that the Tab key is to reach: seen, enabled, and made for it."""
    found = []
    for widget in window.findChildren(QWidget):
        seen = widget.isVisible() and widget.window() is window and widget.isEnabled()
        tabbed = (widget.focusPolicy() & Qt.FocusPolicy.TabFocus) == Qt.FocusPolicy.TabFocus
        own = not _is_inner(widget) and widget.focusProxy() is None
        if seen and tabbed and own and _speaks_for_its_group(widget):
            found.append(widget)
    return found


def _speaks_for_its_group(widget: QWidget) -> bool:
    """Of radio buttons the chosen one is reached by Tab, the others by arrow keys."""
    parent = widget.parentWidget()
    if not isinstance(widget, QRadioButton) or parent is None:
        return True
    return widget.isChecked() or not any(
        one.isChecked() for one in parent.findChildren(QRadioButton)
    )


def tab_faults(window: QWidget) -> list[str]:
    """Who is not reached by Tab, or twice, and where the order goes against reading."""
    order = tab_order(window)
    wanted = stops(window)
    found = [f"not reached: {_named(one)}" for one in wanted if one not in order]
    found += [f"reached twice: {_named(one)}" for one in set(order) if order.count(one) > 1]
    found += [f"Tab is trapped at {_named(order[-1])}" for _ in [0] if len(order) > _MOST_STEPS]
    for before, after in pairwise(order):
        if _reads_before(window, after, before):
            found.append(f"{_named(after)} is reached after {_named(before)}, which is read later")
    return found


def _reads_before(window: QWidget, one: QWidget, other: QWidget) -> bool:
    """Whether one is read before the other: in what both stand in, in the row above or left."""
    one_part, other_part = _parts(one, other)
    first, second = _rect(window, one_part), _rect(window, other_part)
    if first.bottom() <= second.top() + 2:
        return first.left() < second.right()  # columns beside each other are read one by one
    overlap = min(first.bottom(), second.bottom()) - max(first.top(), second.top())
    same_row = overlap > 0.5 * min(first.height(), second.height())
    return same_row and first.right() <= second.left() + 2


def _parts(one: QWidget, other: QWidget) -> tuple[QWidget, QWidget]:
    """The widgets right below what both stand in."""
    ones, others = _line(one), _line(other)
    for mine, theirs in zip(ones, others, strict=False):
        if mine is not theirs:
            return mine, theirs
    return one, other


def _line(widget: QWidget) -> list[QWidget]:
    """From the window down to the widget."""
    line: list[QWidget] = []
    step: QWidget | None = widget
    while step is not None:
        line.insert(0, step)
        step = None if step.isWindow() else step.parentWidget()
    return line


def _rect(window: QWidget, widget: QWidget) -> QRect:
    return QRect(widget.mapTo(window, QPoint()), widget.size())


def _stop(widget: QWidget) -> QWidget:
    """The control that a part with the keyboard belongs to."""
    step = widget
    while _is_inner(step) and step.parentWidget() is not None:
        step = step.parentWidget()
    return step


def _named(widget: QWidget) -> str:
    interface = QAccessible.queryAccessibleInterface(widget)
    return f"{type(widget).__name__} {interface.text(Text.Name)!r} {_place(widget)}"


def _place(widget: QWidget) -> str:
    names, around = [], widget.parentWidget()
    while around is not None and len(names) < 3:
        names.append(around.objectName() or type(around).__name__)
        around = around.parentWidget()
    return "in " + " of ".join(names)


def acted_on(window: QWidget) -> list[QWidget]:
    """The controls of a window that can be acted on now, whatever keys lead to them."""
    passive = (QScrollBar, QSplitterHandle, QProgressBar)
    seen = (widget for _, widget in interfaces(window) if _is_control(widget))
    return [one for one in seen if one.isEnabled() and not isinstance(one, passive)]


def control_with_keyboard(widget: QWidget) -> QWidget:
    """The control that a part with the keyboard belongs to."""
    return _stop(widget)


def named(widget: QWidget) -> str:
    """A control in words."""
    return _named(widget)
