from collections import Counter
from dataclasses import replace

from app.core.commands import COMMANDS, MENUS, CommandContext, command_items

BY_NAME = {command.name: command for command in COMMANDS}


def _enabled(now: CommandContext) -> set[str]:
    return {item.command for item in command_items(now, frozenset()) if item.enabled}


def test_no_two_commands_share_a_name_or_a_key():
    assert len(BY_NAME) == len(COMMANDS)
    keys = Counter(key for command in COMMANDS for key in command.keys)
    assert [key for key, count in keys.items() if count > 1] == []


def test_every_command_stands_in_a_known_menu():
    assert {command.menu for command in COMMANDS} <= set(MENUS)


def test_the_keys_are_those_of_the_window_page():
    wanted = {
        "play.toggle": "Space",
        "play.next": "Right",
        "play.previous": "Left",
        "play.next10": "Shift+Right",
        "play.next_second": "Ctrl+Right",
        "play.back": "J",
        "play.stop": "K",
        "play.forward": "L",
        "play.start": "Home",
        "play.end": "End",
        "play.goto": "G",
        "tracks.next": "Tab",
        "tracks.swap": "X",
        "tracks.split": "S",
        "tracks.merge": "M",
        "tracks.end_here": "Del",
        "tracks.interpolate": "I",
        "help.keys": "F1",
        "edit.commands": "Ctrl+K",
        "edit.undo": "Ctrl+Z",
        "edit.redo": "Ctrl+Shift+Z",
        "file.save": "Ctrl+S",
    }
    assert {name: BY_NAME[name].keys[0] for name in wanted} == wanted


def test_without_a_recording_only_opening_and_help_are_enabled():
    enabled = _enabled(CommandContext())
    assert {"file.open", "file.demo", "help.keys", "edit.commands"} <= enabled
    assert not enabled & {"play.toggle", "file.save", "tracks.swap", "tracks.track"}


def test_correcting_needs_a_session_and_a_selected_person():
    seen = CommandContext(recording=True, session=True, tracks=True)
    assert "tracks.swap" not in _enabled(seen)
    chosen = CommandContext(recording=True, session=True, tracks=True, selected=True)
    assert {"tracks.swap", "tracks.split", "tracks.merge", "tracks.end_here"} <= _enabled(chosen)


def test_while_a_tracker_is_at_work_nothing_is_corrected_and_the_reason_is_said():
    live = CommandContext(
        recording=True, tracks=True, selected=True, live=True, in_the_way="stop first"
    )
    items = {item.command: item for item in command_items(live, frozenset())}
    assert not items["tracks.swap"].enabled
    assert items["tracks.swap"].why_not == "stop first"
    assert items["tracks.stop"].enabled


def test_a_read_only_session_is_not_corrected():
    now = CommandContext(recording=True, session=True, tracks=True, selected=True, read_only=True)
    assert "tracks.swap" not in _enabled(now)
    assert "file.export" in _enabled(now)


def test_checked_commands_are_ticked():
    items = {i.command: i for i in command_items(CommandContext(), frozenset({"view.grid"}))}
    assert items["view.grid"].checked is True
    assert items["view.trails"].checked is False
    assert items["file.open"].checked is None


def test_nothing_takes_the_place_of_the_session_while_a_tracker_works():
    now = CommandContext(recording=True, session=True, tracks=True)
    assert "file.restore" in _enabled(now)
    assert "file.restore" not in _enabled(replace(now, live=True))


def test_nobody_is_drawn_over_a_result_that_is_in_memory_alone():
    now = CommandContext(recording=True, tracks=True)
    assert {"tracks.draw", "file.import"} <= _enabled(now)
    assert not {"tracks.draw", "file.import"} & _enabled(replace(now, unkept=True))


def test_who_corrects_a_run_without_parts_is_told_where_there_are_some():
    now = CommandContext(recording=True, session=True, tracks=True)
    says = BY_NAME["detector.next"].check
    assert "track with three-part" in says(now)
    assert "correct one that has (Ctrl+R)" in says(replace(now, parts_elsewhere=True))


def test_a_score_is_reported_while_a_tracker_works_but_for_the_tracks_it_finds():
    now = CommandContext(recording=True, session=True, tracks=True, truth=True, live=True)
    assert "file.export_report" in _enabled(now)
    assert "file.export_report" not in _enabled(replace(now, session=False))
    assert "file.export_report" not in _enabled(replace(now, in_the_way="stop first"))
    assert "file.export_report" not in _enabled(replace(now, further=True))
    assert "file.export_report" not in _enabled(replace(now, busy=True))


def test_the_only_camera_of_a_recording_is_not_called_the_left_camera():
    def title(now: CommandContext) -> str:
        return {i.command: i.title for i in command_items(now, frozenset())}["view.left"]

    assert title(CommandContext(recording=True, stereo=True)) == "Left camera"
    assert title(CommandContext(recording=True)) == "Picture"
    assert title(CommandContext()) == "Left camera"
