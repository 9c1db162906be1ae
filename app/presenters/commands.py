"""The catalogue of commands: menus, keys, palette and the list of shortcuts share it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from app.presenters.scenes import CommandItem
from app.presenters.words import tr


@dataclass(frozen=True, slots=True)
class Situation:
    """What commands depend on.

    Attributes:
        recording, session: open. tracks: there is something to select. selected: somebody is.
        editing: a preview waits for Enter. live: a tracker is at work. busy: other long work is.
        stereo, truth: the recording has a right eye, a truth file.
        can_track: a tracker exists for the recording; else `why_no_tracking` says why.
        read_only: the session cannot be saved under its name, e.g. as another window has it open.
    """

    recording: bool = False
    session: bool = False
    tracks: bool = False
    selected: bool = False
    editing: bool = False
    live: bool = False
    busy: bool = False
    can_undo: bool = False
    can_redo: bool = False
    stereo: bool = False
    truth: bool = False
    calibrated: bool = False
    can_track: bool = False
    why_no_tracking: str = ""
    read_only: bool = False

    def while_busy(self) -> Situation:
        """The same while other long work is going on."""
        return replace(self, busy=True)


Check = Callable[[Situation], str]
"""Why a command cannot be done now; "" where it can."""


@dataclass(frozen=True, slots=True)
class Command:
    """One command.

    Attributes:
        name: e.g. "edit.swap". menu: one of `MENUS`, or "" for keys only.
        title: English, translated when shown. keys: default keys, in Qt's portable text.
        check: why it cannot be done now.
        checkable: it is on or off. separated: a line stands above it in its menu.
        icon: of the drawings that ship with the program; "" for none.
    """

    name: str
    menu: str
    title: str
    keys: tuple[str, ...] = ()
    check: Check = lambda _: ""
    checkable: bool = False
    separated: bool = False
    icon: str = ""


MENUS: Final = ("File", "Edit", "View", "Playback", "Tracks", "Review", "Help")


def _recording(now: Situation) -> str:
    return "" if now.recording else tr("open a recording first")


def _session(now: Situation) -> str:
    if not now.session:
        return _recording(now) or tr("track the recording first")
    return tr("wait until the work in progress is done") if now.busy else ""


def _read_only() -> str:
    return tr("the session is read only here: save it under another name first")


def _editable(now: Situation) -> str:
    if now.live:
        return tr("stop tracking first, then correct")
    if now.read_only:
        return _read_only()
    return _session(now)


def _selected(now: Situation) -> str:
    return _editable(now) or ("" if now.selected else tr("select a person first"))


def _trackable(now: Situation) -> str:
    if now.live:
        return tr("a tracker is at work")
    if now.busy:
        return tr("wait until the work in progress is done")
    if now.read_only:
        return _read_only()
    return _recording(now) or ("" if now.can_track else now.why_no_tracking)


def _two_eyes(now: Situation) -> str:
    return _recording(now) or ("" if now.stereo else tr("the recording has one camera"))


def _floor(now: Situation) -> str:
    said = tr("the recording does not say where the floor is")
    return _recording(now) or ("" if now.calibrated else said)


COMMANDS: Final[tuple[Command, ...]] = (
    Command("file.open", "File", "Open...", ("Ctrl+O",), icon="open"),
    Command("file.open_folder", "File", "Open folder...", ("Ctrl+Shift+O",)),
    Command("file.demo", "File", "Try the demo", icon="demo"),
    Command("file.save", "File", "Save", ("Ctrl+S",), _session, separated=True, icon="save"),
    Command("file.save_as", "File", "Save as...", ("Ctrl+Shift+S",), _session),
    Command("file.export_mot", "File", "Export MOT text...", ("Ctrl+E",), _session, icon="export"),
    Command("file.close", "File", "Close recording", ("Ctrl+W",), _recording, separated=True),
    Command("file.quit", "File", "Quit", ("Ctrl+Q",)),
    Command(
        "edit.undo",
        "Edit",
        "Undo",
        ("Ctrl+Z",),
        lambda now: _editable(now) or ("" if now.can_undo else tr("nothing to undo")),
        icon="undo",
    ),
    Command(
        "edit.redo",
        "Edit",
        "Redo",
        ("Ctrl+Shift+Z", "Ctrl+Y"),
        lambda now: _editable(now) or ("" if now.can_redo else tr("nothing to redo")),
        icon="redo",
    ),
    Command(
        "edit.commands", "Edit", "Search commands...", ("Ctrl+K",), separated=True, icon="search"
    ),
    Command("view.left", "View", "Left eye", ("1",), _recording, checkable=True),
    Command("view.both", "View", "Both eyes", ("2",), _two_eyes, True),
    Command("view.anaglyph", "View", "Anaglyph (red and cyan)", ("3",), _two_eyes, True),
    Command("view.grid", "View", "Floor grid on the picture", ("F",), _floor, True, True),
    Command("view.particles", "View", "Particles on the picture", ("O",), _recording, True),
    Command("view.trails", "View", "Trails on the picture", ("T",), _recording, True),
    Command(
        "view.foreground",
        "View",
        "Foreground and shadows on the picture",
        ("B",),
        lambda now: _two_eyes(now) or _floor(now),
        True,
    ),
    Command(
        "view.disparity",
        "View",
        "Distances (disparity) on the picture",
        ("D",),
        lambda now: _two_eyes(now) or _floor(now),
        True,
    ),
    Command("view.next_pane", "View", "To the next part of the window", ("F6",), _recording),
    Command("view.look_system", "View", "Look: as the system", (), checkable=True, separated=True),
    Command("view.look_light", "View", "Look: light", checkable=True),
    Command("view.look_dark", "View", "Look: dark", checkable=True),
    Command("play.toggle", "Playback", "Play or pause", ("Space",), _recording, icon="play"),
    Command("play.next", "Playback", "Next frame", ("Right",), _recording, separated=True),
    Command("play.previous", "Playback", "Previous frame", ("Left",), _recording),
    Command("play.next10", "Playback", "Ten frames on", ("Shift+Right",), _recording),
    Command("play.previous10", "Playback", "Ten frames back", ("Shift+Left",), _recording),
    Command("play.next_second", "Playback", "A second on", ("Ctrl+Right",), _recording),
    Command("play.previous_second", "Playback", "A second back", ("Ctrl+Left",), _recording),
    Command("play.start", "Playback", "To the start", ("Home",), _recording),
    Command("play.end", "Playback", "To the end", ("End",), _recording),
    Command("play.goto", "Playback", "Go to frame...", ("G",), _recording),
    Command(
        "play.back", "Playback", "Shuttle back (again: faster)", ("J",), _recording, separated=True
    ),
    Command("play.stop", "Playback", "Shuttle stop", ("K",), _recording),
    Command("play.forward", "Playback", "Shuttle on (again: faster)", ("L",), _recording),
    Command("play.slower", "Playback", "Slower", (",",), _recording),
    Command("play.faster", "Playback", "Faster", (".",), _recording),
    Command("tracks.track", "Tracks", "Track...", ("Ctrl+T",), _trackable, icon="live"),
    Command(
        "tracks.stop",
        "Tracks",
        "Stop tracking, keep the result",
        ("Ctrl+Shift+T",),
        lambda now: "" if now.live else tr("no tracker is at work"),
    ),
    Command(
        "tracks.next",
        "Tracks",
        "Select next track",
        ("Tab",),
        lambda now: "" if now.tracks else tr("there are no tracks yet"),
        separated=True,
    ),
    Command(
        "tracks.previous",
        "Tracks",
        "Select previous track",
        ("Shift+Tab",),
        lambda now: "" if now.tracks else tr("there are no tracks yet"),
    ),
    Command(
        "tracks.none",
        "Tracks",
        "Select nobody, leave the edit",
        ("Esc",),
        lambda now: "" if now.selected or now.editing else tr("nobody is selected"),
    ),
    Command(
        "tracks.to_start",
        "Tracks",
        "Go to where the track begins",
        ("Shift+Home",),
        lambda now: "" if now.selected else tr("select a person first"),
    ),
    Command(
        "tracks.to_end",
        "Tracks",
        "Go to where the track ends",
        ("Shift+End",),
        lambda now: "" if now.selected else tr("select a person first"),
    ),
    Command(
        "tracks.swap", "Tracks", "Swap with...", ("X",), _selected, separated=True, icon="swap"
    ),
    Command("tracks.split", "Tracks", "Split here", ("S",), _selected, icon="split"),
    Command("tracks.merge", "Tracks", "Merge with...", ("M",), _selected, icon="merge"),
    Command("tracks.end_here", "Tracks", "Delete from here on", ("Del",), _selected, icon="delete"),
    Command(
        "tracks.confirm",
        "Tracks",
        "Do the edit shown",
        ("Return", "Enter"),
        lambda now: "" if now.editing else tr("no edit is waiting"),
    ),
    Command(
        "tracks.scope",
        "Tracks",
        "Next choice of the edit shown",
        ("R",),
        lambda now: "" if now.editing else tr("no edit is waiting"),
    ),
    Command("tracks.rename", "Tracks", "Name the person", ("F2",), _selected, separated=True),
    Command(
        "review.score",
        "Review",
        "Score against truth...",
        (),
        lambda now: _session(now) or ("" if now.truth else tr("the recording has no truth.txt")),
    ),
    Command("help.keys", "Help", "All shortcuts", ("F1",)),
    Command("help.about", "Help", "About trackwright"),
)

BY_NAME: Final = {command.name: command for command in COMMANDS}


def command_items(now: Situation, checked: frozenset[str]) -> tuple[CommandItem, ...]:
    """All commands as the views show them now; `checked` holds those that are on."""
    return tuple(_item(command, now, checked) for command in COMMANDS)


def _item(command: Command, now: Situation, checked: frozenset[str]) -> CommandItem:
    why_not = command.check(now)
    return CommandItem(
        command=command.name,
        menu=tr(command.menu),
        title=tr(command.title),
        keys=command.keys,
        enabled=not why_not,
        why_not=why_not,
        checked=command.name in checked if command.checkable else None,
    )
