from __future__ import annotations

import pytest
from fake_window import items_of, window_app
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QLabel, QPushButton, QWidget

from app.core.i18n import use_language
from app.core.scenes import CommandItem, RecentItem, WelcomeScene
from app.features.welcome.welcome import WelcomePage
from app.features.welcome.welcome_parts import RecentRow
from app.shell.command_palette import CommandPalette, best_commands, match_score
from app.shell.shortcuts import ShortcutsDialog

LEFT = Qt.MouseButton.LeftButton
ITEMS = (
    CommandItem("file.open", "File", "Open...", ("Ctrl+O",), True),
    CommandItem("tracks.swap", "Tracks", "Swap with...", ("X",), True),
    CommandItem("playback.forward", "Playback", "Frame forward", ("Right", "D"), True),
    CommandItem("tracks.delete", "Tracks", "Delete from here", ("Del",), True),
    CommandItem("file.export", "File", "Export tracks...", (), False, "no session"),
)


@pytest.fixture
def palette(qtbot, dark):
    window = QWidget()
    qtbot.addWidget(window)
    window.resize(900, 700)
    made = CommandPalette(window)
    made.show_scene(ITEMS)
    made.open_over(window)
    yield made
    made.hide()


def test_a_few_letters_find_a_command():
    assert best_commands("ff", ITEMS)[0].command == "playback.forward"
    assert best_commands("dfh", ITEMS)[0].command == "tracks.delete"
    assert best_commands("qqq", ITEMS) == []


def test_a_word_as_it_is_written_comes_before_scattered_letters():
    assert match_score("swap", "Swap with...") > match_score("swap", "Show what a person does")


def test_what_can_be_done_now_comes_before_what_cannot_and_matches_as_well():
    able = CommandItem("view.score", "View", "Show the score", (), True)
    unable = CommandItem("file.report", "File", "Export a score report...", (), False, "no score")
    scattered = CommandItem("a.b", "View", "Sort columns or reset", (), True)
    assert match_score("score", unable.title) > match_score("score", able.title)
    assert best_commands("score", (scattered, unable, able)) == [able, unable]


def test_a_title_comes_before_further_words_and_is_found_in_english_too():
    also = "language English Japanese"
    ja = CommandItem("ja", "表示", "言語: 日本語", (), True, also=also, english="Language: 日本語")
    en = CommandItem(
        "en", "表示", "言語: English", (), True, also=also, english="Language: English"
    )
    reset = CommandItem("view.reset", "表示", "配置を戻す", (), True, english="Reset layout")
    assert best_commands("English", (ja, reset, en)) == [en, ja]
    assert best_commands("reset lay", (ja, reset, en)) == [reset]


def test_commands_know_their_english_titles_in_another_language(controller, window):
    use_language("ja")
    item = window.registry.item("view.layout_reset")
    use_language("en")
    assert item.title != item.english == "Reset layout"


def test_letters_strewn_over_a_command_do_not_find_it():
    strewn = (
        CommandItem("review.next", "Review", "Next review item", (), True),
        CommandItem("tracks.reset", "Correct", "Merge with the rest", (), True),
        CommandItem("view.keys", "View", "Restore the backup", (), True),
    )
    assert match_score("reset", "Restore the backup") is not None
    assert best_commands("reset", strewn) == []
    layout = CommandItem("view.reset", "View", "Reset layout", (), False)
    assert best_commands("reset", (*strewn, layout)) == [layout]


def test_words_are_found_in_any_order():
    assert best_commands("tracks exp", ITEMS)[0].command == "file.export"


def test_all_commands_are_listed_before_anything_is_typed():
    assert best_commands(" ", ITEMS) == list(ITEMS)


def test_enter_runs_what_the_arrows_chose(palette, qtbot):
    qtbot.keyClick(palette._edit, Qt.Key.Key_Down)
    with qtbot.waitSignal(palette.run_asked) as asked:
        qtbot.keyClick(palette._edit, Qt.Key.Key_Return)
    assert asked.args == ["tracks.swap"]
    assert palette.isHidden()


def test_typing_narrows_the_list(palette, qtbot):
    qtbot.keyClicks(palette._edit, "open")
    assert palette._list.count() == 1
    qtbot.keyClicks(palette._edit, "qqq")
    assert palette._list.count() == 0
    assert not palette._none.isHidden()


def test_a_command_that_cannot_run_now_is_listed_and_not_run(palette, qtbot, heard):
    asked = heard(palette.run_asked)
    qtbot.keyClicks(palette._edit, "export")
    qtbot.keyClick(palette._edit, Qt.Key.Key_Return)
    assert asked == []
    assert not palette.isHidden()


def test_escape_closes_the_palette(palette, qtbot):
    qtbot.keyClick(palette._edit, Qt.Key.Key_Escape)
    assert palette.isHidden()


def test_the_palette_is_drawn_with_keys(palette, drawn):
    assert not drawn(palette).isNull()


def shown_words(dialog) -> list[str]:
    return [label.text() for label in dialog._scroll.widget().findChildren(QLabel)]


def test_shortcuts_are_grouped_by_menu_and_leave_out_commands_without_keys(qtbot, dark):
    dialog = ShortcutsDialog(ITEMS)
    qtbot.addWidget(dialog)
    said = shown_words(dialog)
    assert {"File", "Tracks", "Playback", "Swap with...", "X", "Right", "D"} <= set(said)
    assert "Export tracks..." not in said


def test_shortcuts_are_found_by_name_and_by_key(qtbot, dark):
    dialog = ShortcutsDialog(ITEMS)
    qtbot.addWidget(dialog)
    dialog.narrow("ctrl+o")
    assert "Open..." in shown_words(dialog)
    assert "Swap with..." not in shown_words(dialog)


@pytest.fixture
def welcome(qtbot, theme):
    page = WelcomePage()
    qtbot.addWidget(page)
    page.resize(1000, 700)
    return page


def test_recent_recordings_are_opened_by_a_click(welcome, qtbot, tmp_path):
    welcome.show_scene(WelcomeScene((RecentItem(str(tmp_path), "Lobby", "stereo"),)))
    with qtbot.waitSignal(welcome.path_chosen) as chosen:
        qtbot.mouseClick(welcome.findChild(RecentRow), LEFT)
    assert chosen.args == [tmp_path]


def test_what_is_gone_cannot_be_opened(welcome):
    welcome.show_scene(WelcomeScene((RecentItem("/gone", "Hall", "", exists=False),)))
    assert not welcome.findChild(RecentRow).isEnabled()


def test_a_notice_is_said_above(welcome):
    assert welcome._notice.isHidden()
    welcome.show_scene(WelcomeScene(notice="The window closed without saving."))
    assert not welcome._notice.isHidden()


def test_the_choices_are_open_and_demo(welcome, qtbot, heard):
    asked = [heard(welcome.open_asked), heard(welcome.demo_asked)]
    for choice in welcome.findChildren(QPushButton):
        qtbot.mouseClick(choice, LEFT)
    assert [len(one) for one in asked] == [1, 1]


def test_all_that_is_dropped_is_told(welcome, qtbot, tmp_path):
    carried = QMimeData()
    urls = [QUrl.fromLocalFile(str(tmp_path / name)) for name in ("left.mp4", "right.mp4")]
    carried.setUrls(urls)
    event = QDropEvent(
        QPointF(QPoint(50, 50)),
        Qt.DropAction.CopyAction,
        carried,
        LEFT,
        Qt.KeyboardModifier.NoModifier,
    )
    with qtbot.waitSignal(welcome.dropped) as dropped:
        welcome.dropEvent(event)
    assert dropped.args == [urls]


def test_the_page_is_drawn_with_and_without_recent_recordings(welcome, drawn):
    empty = drawn(welcome)
    welcome.show_scene(WelcomeScene((RecentItem("/somewhere", "Lobby", "stereo"),)))
    assert drawn(welcome) != empty


def test_no_shortcut_is_cut_off_at_the_side(qtbot, dark):
    wide = [
        CommandItem(f"a.{n}", f"Menu {n}", "A rather long title " * 2, ("Ctrl+Shift+Z",), True)
        for n in range(9)
    ]
    dialog = ShortcutsDialog(tuple(wide))
    qtbot.addWidget(dialog)
    dialog.show()
    dialog.grab()
    page, viewport = dialog._scroll.widget(), dialog._scroll.viewport()
    assert page.sizeHint().width() <= viewport.width()


@pytest.mark.parametrize("typed", ["theme", "dark", "light"])
def test_words_for_the_look_find_it_first(typed):
    found = best_commands(typed, tuple(items_of(window_app()).values()))
    assert found[0].command.startswith("view.look_")


@pytest.mark.parametrize("typed", ["zoom", "fit", "whole"])
def test_words_for_it_find_the_command_that_shows_the_whole_picture(typed):
    found = best_commands(typed, tuple(items_of(window_app()).values()))
    assert "view.whole" in [item.command for item in found]


@pytest.mark.parametrize(
    ("typed", "command"),
    [
        ("settings", "tracks.track"),
        ("settings", "tracks.runs"),
        ("graph", "view.curves"),
        ("plot", "view.counting"),
        ("plug", "tracks.track"),
    ],
)
def test_words_of_engineers_find_the_command(typed, command):
    found = best_commands(typed, tuple(items_of(window_app()).values()))
    assert command in [item.command for item in found]
