"""The order in which the Tab key goes through controls: as they stand, not as they were made."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QFormLayout,
    QGridLayout,
    QLayout,
    QScrollArea,
    QSplitter,
    QStackedWidget,
    QWidget,
)

_WHOLE = (QAbstractItemView, QAbstractSpinBox, QComboBox)
"""Controls that are made of others."""


def tab_in_reading_order(window: QWidget) -> None:
    """Have Tab go from row to row, and in a row from left to right, as layouts have it.

    Call it again where controls come or go.
    """
    controls = [one for one in widgets_in_order(window) if _takes_tab(one)]
    for one, other in pairwise(controls):
        QWidget.setTabOrder(one, other)


def widgets_in_order(widget: QWidget) -> Iterator[QWidget]:
    """All widgets inside of one, as they are read."""
    for child in _children(widget):
        yield child
        if not isinstance(child, _WHOLE):
            yield from widgets_in_order(child)


def _children(widget: QWidget) -> Iterator[QWidget]:
    if isinstance(widget, QScrollArea):
        inner = widget.widget()
        if inner is not None:
            yield inner
    elif isinstance(widget, (QSplitter, QStackedWidget)):
        inside = (widget.widget(at) for at in range(widget.count()))
        yield from (one for one in inside if one is not None)
    elif (layout := widget.layout()) is not None:
        yield from _laid_out(layout)


def _laid_out(layout: QLayout) -> Iterator[QWidget]:
    for at in _places(layout):
        item = layout.itemAt(at)
        if item is None:
            continue
        if (widget := item.widget()) is not None:
            yield widget
        elif (inner := item.layout()) is not None:
            yield from _laid_out(inner)


def _places(layout: QLayout) -> list[int]:
    """The numbers of a layout's items in the order in which they are read."""
    places = list(range(layout.count()))
    if not isinstance(layout, (QGridLayout, QFormLayout)):
        return places
    position: Callable[[int], Any] = layout.getItemPosition
    return sorted(places, key=lambda at: _row_and_column(*position(at)[:2]))


def _row_and_column(row: int, column: int | QFormLayout.ItemRole) -> tuple[int, int]:
    """A grid counts columns; a form calls them label and field."""
    return row, column.value if isinstance(column, QFormLayout.ItemRole) else column


def _takes_tab(widget: QWidget) -> bool:
    return bool(widget.focusPolicy() & Qt.FocusPolicy.TabFocus)
