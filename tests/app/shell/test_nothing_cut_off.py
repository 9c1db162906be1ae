"""In Japanese and in a language half again as long nothing that is said is cut off."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from opened_session import PANELS, laid_out, open_with_anna
from PySide6.QtWidgets import QDialog

from app.core.widgets.user_settings import UserSettings
from app.shell import language_choice
from app.shell.application import start_application
from tests.fitting import beyond, cut_off
from tests.pseudo import Longer
from tracking.translation import use_catalogue, use_language

SIZES = ((1000, 640), (1280, 800))
LANGUAGES = ("ja", "longer")
_DIALOGS = (
    *("tracks.track", "file.export", "file.author", "detector.train", "help.keys", "tracks.runs"),
    *("file.restore", "file.setup_again", "edit.commands", "help.doctor"),
)


_LOOKS = 20
"""How often something cut off is looked at again, 60 ms apart."""


@pytest.fixture(params=LANGUAGES)
def language(request, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """The language that the window is built in."""
    uses = {"ja": lambda *_: use_language("ja"), "longer": lambda *_: use_catalogue(Longer())}
    monkeypatch.setattr(language_choice, "use_language", uses[request.param])
    yield request.param
    use_catalogue(None)
    monkeypatch.undo()


@pytest.fixture(params=SIZES, ids=lambda size: "x".join(map(str, size)))
def opened(language, window, qtbot, request, parted_session):
    """The window on a session, somebody selected, nothing looked for any more."""
    window.resize(*request.param)
    open_with_anna(window, qtbot, parted_session)
    return window


@pytest.fixture(autouse=True)
def english_again(qapp, remembered: UserSettings) -> Iterator[None]:
    """Qt's own texts and letters are those of the other tests afterwards."""
    yield
    use_catalogue(None)
    start_application(remembered)


def faults(window, qtbot) -> str:
    """What is cut off and stays so; a layout may take a while on a busy machine."""
    for _ in range(_LOOKS):
        found = "\n".join((*cut_off(window), *beyond(window)))
        if not found:
            break
        laid_out(qtbot)
    return found


def test_the_window_and_its_panels(opened, qtbot) -> None:
    found = [faults(opened, qtbot)]
    for name in PANELS:
        opened.run_command(name)
        laid_out(qtbot)
        found.append(f"{name}: {text}" if (text := faults(opened, qtbot)) else "")
        opened.run_command(name)
        laid_out(qtbot)
    opened.run_command("tracks.swap")
    laid_out(qtbot)
    found.append(faults(opened, qtbot))
    assert "\n".join(filter(None, found)) == ""


def test_the_dialogs(opened, qtbot) -> None:
    found = []
    for name in _DIALOGS:
        opened.run_command(name)
        laid_out(qtbot)
        dialogs = [one for one in opened.findChildren(QDialog) if one.isVisible()]
        for dialog in dialogs or [opened.palette_of_commands]:
            found += [f"{name}: {text}"] if (text := faults(dialog, qtbot)) else []
            dialog.close()
        laid_out(qtbot)
    assert "\n".join(found) == ""


@pytest.mark.parametrize("size", SIZES)
def test_the_first_page(language, window, qtbot, size) -> None:
    window.resize(*size)
    laid_out(qtbot)
    assert faults(window, qtbot) == ""


def test_the_menus_open_on_the_screen_with_all_they_say(opened) -> None:
    room = opened.screen().availableSize()
    for menu in opened.menus.menus.values():
        assert menu.sizeHint().width() <= room.width()
