"""The look that is remembered from one start to the next."""

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings

from app.core.look.theme import Look
from app.core.widgets.user_settings import UserSettings
from app.shell.look_choice import look_of


@pytest.fixture
def remembered(tmp_path: Path) -> UserSettings:
    return UserSettings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))


@pytest.mark.parametrize("look", Look)
def test_the_look_that_was_chosen_is_had_again(remembered, look):
    remembered.set_text("look", look.value)
    assert look_of(remembered) is look


@pytest.mark.parametrize("word", ["", "sepia", "DARK"])
def test_a_word_that_is_no_look_is_that_of_the_system(remembered, word):
    remembered.set_text("look", word)
    assert look_of(remembered) is Look.SYSTEM
