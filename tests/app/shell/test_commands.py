from __future__ import annotations

from collections import Counter

from fake_window import enabled, items_of, window_app

from app.core.commands import MENUS, menu_of
from app.core.tracks.frame_state import ViewOptions
from app.features.parts.commands import tracked
from app.shell.commands import COMMANDS

BY_ID = {command.id: command for command in COMMANDS}


def test_no_two_commands_share_an_id_or_a_key():
    assert len(BY_ID) == len(COMMANDS)
    keys = Counter(key for command in COMMANDS for key in command.keys)
    assert [key for key, count in keys.items() if count > 1] == []


def test_every_command_stands_in_a_known_menu():
    assert {menu_of(command)[0] for command in COMMANDS} <= set(MENUS)


def test_every_command_does_something():
    assert [one.id for one in COMMANDS if one.run.__module__ == "app.core.commands.command"] == []


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
    assert {name: BY_ID[name].keys[0] for name in wanted} == wanted


def test_without_a_recording_only_opening_and_help_are_enabled():
    now = enabled(window_app(recording=False))
    assert {"file.open", "file.demo", "help.keys", "edit.commands"} <= now
    assert not now & {"play.toggle", "file.save", "tracks.swap", "tracks.track"}


def test_correcting_needs_a_session_and_a_selected_person():
    assert "tracks.swap" not in enabled(window_app())
    chosen = enabled(window_app(selected=True))
    assert {"tracks.swap", "tracks.split", "tracks.merge", "tracks.end_here"} <= chosen
    assert "tracks.swap" not in enabled(window_app(selected=True, session=False))


def test_while_a_tracker_is_at_work_nothing_is_corrected_and_the_reason_is_said():
    now = window_app(session=False, selected=True, live=True, in_the_way="stop first")
    items = items_of(now)
    assert not items["tracks.swap"].enabled
    assert items["tracks.swap"].why_not == "stop first"
    assert items["tracks.stop"].enabled


def test_a_read_only_session_is_not_corrected():
    now = enabled(window_app(selected=True, read_only=True))
    assert "tracks.swap" not in now
    assert "file.export" in now


def test_commands_that_are_on_are_ticked():
    items = items_of(window_app(view_options=ViewOptions(grid=True, trails=False)))
    assert items["view.grid"].checked is True
    assert items["view.trails"].checked is False
    assert items["file.open"].checked is None


def test_nothing_is_ticked_without_a_recording_but_the_look_and_the_detector():
    ticked = {name for name, item in items_of(window_app(recording=False)).items() if item.checked}
    assert ticked == {"detector.built_in"}


def test_nothing_takes_the_place_of_the_session_while_a_tracker_works():
    assert "file.restore" in enabled(window_app())
    assert "file.restore" not in enabled(window_app(live=True))


def test_nobody_is_drawn_over_a_result_that_is_in_memory_alone():
    wanted = {"tracks.draw", "file.import"}
    assert wanted <= enabled(window_app(session=False))
    assert not wanted & enabled(window_app(session=False, unkept=True))


def test_who_corrects_a_run_without_parts_is_told_where_there_are_some():
    assert "track with three-part" in tracked(window_app())
    assert "correct one that has (Ctrl+R)" in tracked(window_app(elsewhere=True))


def test_a_score_is_reported_while_a_tracker_works_but_for_the_tracks_it_finds():
    report = "file.export_report"
    assert report in enabled(window_app(truth=True, live=True))
    assert report not in enabled(window_app(truth=True, live=True, session=False))
    assert report not in enabled(window_app(truth=True, live=True, in_the_way="stop first"))
    assert report not in enabled(window_app(truth=True, live=True, further=True))
    assert report not in enabled(window_app(truth=True, live=True, busy=True))


def test_the_only_camera_of_a_recording_is_not_called_the_left_camera():
    assert items_of(window_app())["view.left"].title == "Left camera"
    assert items_of(window_app(stereo=False))["view.left"].title == "Image"
    assert items_of(window_app(recording=False))["view.left"].title == "Left camera"
