"""Nothing moves by itself but the footage: so that nobody needs to ask for less motion."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from PySide6.QtWidgets import QApplication

import app
from app.core.widgets.user_settings import UserSettings
from app.shell.application import start_application

_MOVING = {
    *("QPropertyAnimation", "QVariantAnimation", "QSequentialAnimationGroup", "QMovie"),
    *("QParallelAnimationGroup", "QTimeLine", "QScroller", "setAnimated", "QAbstractAnimation"),
    *("QGraphicsOpacityEffect", "setBusyIndicator"),
}
_FILES = sorted(Path(app.__file__).parent.rglob("*.py"))


def _names(text: str) -> set[str]:
    tree = ast.walk(ast.parse(text))
    return {
        getattr(node, "id", getattr(node, "attr", getattr(node, "name", None))) for node in tree
    }


def test_nothing_is_animated():
    moving = [path.name for path in _FILES if _MOVING & _names(path.read_text("utf-8"))]
    assert len(_FILES) > 300
    assert not moving


def test_no_progress_runs_to_and_fro():
    assert not [path.name for path in _FILES if "setRange(0, 0)" in path.read_text("utf-8")]


@pytest.mark.parametrize("effect", ["UI_AnimateMenu", "UI_AnimateCombo", "UI_AnimateTooltip"])
def test_menus_and_lists_open_at_once(qapp, tmp_path, effect):
    QApplication.setEffectEnabled(getattr(Qt.UIEffect, effect), True)
    settings = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    start_application(UserSettings(settings))
    assert not QApplication.isEffectEnabled(getattr(Qt.UIEffect, effect))


def test_a_name_of_something_moving_is_found():
    assert "QTimeLine" in _names("from PySide6.QtCore import QTimeLine")
    assert "setAnimated" in _names("tree.setAnimated(True)")
