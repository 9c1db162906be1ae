"""The commands of the Tracks menu."""

from __future__ import annotations

from typing import Final

from app.presenters.commands.checks import (
    drawable,
    on_floor,
    placing,
    selected,
    session,
    trackable,
    waiting,
)
from app.presenters.commands.command import Command
from app.presenters.words import tr

COMMANDS: Final = (
    Command("tracks.track", "Tracks", "Track...", ("Ctrl+T",), trackable, icon="live"),
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
        lambda now: (
            "" if now.selected or now.editing or now.labelling else tr("nobody is selected")
        ),
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
    Command("tracks.swap", "Tracks", "Swap with...", ("X",), selected, separated=True, icon="swap"),
    Command("tracks.split", "Tracks", "Split here", ("S",), selected, icon="split"),
    Command("tracks.merge", "Tracks", "Merge with...", ("M",), selected, icon="merge"),
    Command("tracks.reassign", "Tracks", "Give to another id...", ("A",), selected),
    Command(
        "tracks.end_here",
        "Tracks",
        "Delete from here on",
        ("Del",),
        selected,
        separated=True,
        icon="delete",
    ),
    Command("tracks.delete_range", "Tracks", "Delete a range", ("Alt+Del",), selected),
    Command("tracks.delete_frame", "Tracks", "Delete in this frame", ("Shift+Del",), selected),
    Command("tracks.delete_track", "Tracks", "Delete the whole track", ("Ctrl+Del",), selected),
    Command("tracks.draw", "Tracks", "Draw a box", ("W",), drawable, separated=True, icon="box"),
    Command("tracks.new", "Tracks", "Draw a new person", ("Ins",), drawable, icon="add"),
    Command("tracks.move_box", "Tracks", "Move or resize the box", ("V",), selected),
    Command("tracks.move_floor", "Tracks", "Move on the floor", ("Shift+V",), on_floor),
    Command(
        "tracks.keyframe", "Tracks", "Make this a keyframe", ("Shift+W",), selected, separated=True
    ),
    Command("tracks.no_keyframe", "Tracks", "Take the keyframe out", ("Ctrl+Shift+W",), selected),
    Command("tracks.interpolate", "Tracks", "Interpolate between keyframes", ("I",), selected),
    Command("tracks.fill_gap", "Tracks", "Fill the gap", ("Shift+I",), selected),
    Command("tracks.thin", "Tracks", "Make keyframes of what was tracked", (), selected),
    Command("tracks.occluded", "Tracks", "Mark as occluded", ("H",), selected, separated=True),
    Command("tracks.visible", "Tracks", "Mark as visible", ("Shift+H",), selected),
    Command("tracks.reviewed", "Tracks", "Mark as reviewed", ("Y",), selected),
    Command("tracks.range_start", "Tracks", "Range begins here", ("[",), session, separated=True),
    Command("tracks.range_end", "Tracks", "Range ends here", ("]",), session),
    Command("tracks.no_range", "Tracks", "No range", ("\\",), session),
    Command(
        "tracks.confirm",
        "Tracks",
        "Do the edit shown",
        ("Return", "Enter"),
        waiting,
        separated=True,
    ),
    Command("tracks.scope", "Tracks", "How far the edit goes", ("R",), waiting),
    Command("tracks.way", "Tracks", "How the edit is done", ("C",), waiting),
    Command("tracks.down", "Tracks", "Next proposal, or box down", ("Down",), waiting),
    Command("tracks.up", "Tracks", "Previous proposal, or box up", ("Up",), waiting),
    Command("tracks.far_down", "Tracks", "Box far down", ("Shift+Down",), placing),
    Command("tracks.far_up", "Tracks", "Box far up", ("Shift+Up",), placing),
    Command("tracks.taller", "Tracks", "Box taller", ("Ctrl+Down",), placing),
    Command("tracks.shorter", "Tracks", "Box shorter", ("Ctrl+Up",), placing),
    Command("tracks.rename", "Tracks", "Name the person", ("F2",), selected, separated=True),
    Command("tracks.attributes", "Tracks", "Attributes of the person", ("Shift+F2",), selected),
    Command("tracks.notes", "Tracks", "Notes on the person", ("Ctrl+F2",), selected),
)
