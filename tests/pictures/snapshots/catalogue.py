"""All snapshots, and what of the window none of them shows."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages

from PySide6.QtWidgets import QDialog, QMessageBox, QWidget

import app
from app.core.editing import edits
from app.core.feature import FeaturePanel
from app.core.widgets.fitted_scroll import ScrolledPanel
from app.core.widgets.parts import Panel
from app.features.setup.step_page import StepPage
from tests.pictures.snapshots import dialogs, pages, panels, project, setup  # noqa: F401 - declare
from tests.pictures.snapshots import edits as edit_snapshots
from tests.pictures.snapshots.snapshot import Snapshot, declared

SNAPSHOTS: tuple[Snapshot, ...] = declared()
_BASES = (QDialog, Panel, StepPage, ScrolledPanel)
_ABSTRACT = {Panel, FeaturePanel, StepPage, ScrolledPanel}
_PAGES_AND_BARS = ("Page", "Panel", "Bar", "Palette", "Strip", "Window")
"""How classes end that are parts of the window of their own, whatever they derive from."""
_NO_PARTS = {"BalanceBar", "LanesBar", "TimeBar", "OverviewStrip", "MainWindow"}
"""Bits of a part; and the window, which all pictures of pages show."""
_ASKED_BY_QT = {"QMessageBox", "QInputDialog", "QFileDialog"}


def uncovered() -> Iterator[str]:
    """What no snapshot covers: classes of dialogs and panels, questions, edits."""
    covered = {one for each in SNAPSHOTS for one in each.covers}
    for kind in widget_classes():
        if _is_part(kind) and kind not in covered:
            yield f"{kind.__module__}.{kind.__name__}"
    yield from sorted(questions() - covered)
    for spec in edits.EDITS:
        if edit_snapshots.covers(spec) not in covered:
            yield edit_snapshots.covers(spec)


def unknown() -> Iterator[str]:
    """What snapshots say to cover, and what there is not."""
    there = {*questions(), *(edit_snapshots.covers(spec) for spec in edits.EDITS)}
    for each in SNAPSHOTS:
        yield from (one for one in each.covers if isinstance(one, str) and one not in there)


@cache
def widget_classes() -> tuple[type[QWidget], ...]:
    """All classes of widgets that the program declares."""
    found: dict[type[QWidget], None] = {}
    for module in walk_packages(app.__path__, "app."):
        if module.name.endswith("__main__"):
            continue
        for value in vars(import_module(module.name)).values():
            own = isinstance(value, type) and value.__module__ == module.name
            if own and issubclass(value, QWidget):
                found[value] = None
    return tuple(found)


def _is_part(kind: type[QWidget]) -> bool:
    if kind in _ABSTRACT or kind.__name__ in _NO_PARTS or kind.__name__.startswith("_"):
        return False
    return issubclass(kind, _BASES) or kind.__name__.endswith(_PAGES_AND_BARS)


@cache
def questions() -> set[str]:
    """The functions that show a dialog of Qt's own, "module:function"."""
    root = Path(app.__path__[0])
    found = set()
    for path in root.rglob("*.py"):
        module = ".".join(path.relative_to(root.parent).with_suffix("").parts)
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.FunctionDef) and _asks(node):
                found.add(f"{module}:{node.name}")
    return found


def _asks(function: ast.FunctionDef) -> bool:
    calls = (node.func for node in ast.walk(function) if isinstance(node, ast.Call))
    return any(isinstance(call, ast.Name) and call.id in _ASKED_BY_QT for call in calls)


def unseen(classes: set[type[QWidget]]) -> Iterator[str]:
    """The classes of widgets that are in no picture though none of them is abstract."""
    for kind in widget_classes():
        shown = any(issubclass(one, kind) for one in classes)
        if not shown and kind not in _ABSTRACT and not issubclass(kind, QMessageBox):
            yield f"{kind.__module__}.{kind.__name__}"
