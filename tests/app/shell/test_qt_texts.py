"""Qt's own texts are in the language of ours."""

from __future__ import annotations

import gettext
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QSettings, QTranslator
from PySide6.QtWidgets import QDialogButtonBox

from app.core.widgets.user_settings import UserSettings
from app.shell import language_choice
from app.shell.application import start_application
from tracking.translation import use_catalogue


@pytest.fixture
def remembered(tmp_path) -> UserSettings:
    return UserSettings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))


class German(gettext.NullTranslations):
    def info(self) -> dict[str, str]:
        return {"language": "de"}


@pytest.fixture
def german(monkeypatch: pytest.MonkeyPatch, qapp) -> Iterator[None]:
    monkeypatch.setattr(language_choice, "use_language", lambda: use_catalogue(German()))
    yield
    use_catalogue(None)
    for translator in qapp.findChildren(QTranslator):
        qapp.removeTranslator(translator)


def cancel_text(qtbot) -> str:
    box = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
    qtbot.addWidget(box)
    return box.button(QDialogButtonBox.StandardButton.Cancel).text()


def test_buttons_of_qt_are_in_the_language_of_the_program(german, qtbot, remembered) -> None:
    start_application(remembered)
    assert cancel_text(qtbot) == "Abbrechen"


def test_in_english_they_stay_english(qtbot, remembered) -> None:
    start_application(remembered)
    assert cancel_text(qtbot) == "Cancel"
