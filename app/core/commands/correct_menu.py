"""The commands of the Correct menu: everything that changes tracks, and the edit that waits."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.enablement import drawable, on_floor, placing, reaching, selected, waiting

_PEOPLE: Final = (
    Command("tracks.swap", "Correct", "Swap with...", ("X",), selected, icon="swap"),
    Command("tracks.split", "Correct", "Split here", ("S",), selected, icon="split"),
    Command("tracks.merge", "Correct", "Merge with...", ("M",), selected, icon="merge"),
    Command("tracks.reassign", "Correct", "Give to another id...", ("A",), selected),
)
_DELETE: Final = (
    Command(
        "tracks.end_here",
        "Correct",
        "Delete from here on",
        ("Del",),
        selected,
        submenu="Delete",
        separated=True,
        icon="delete",
    ),
    Command(
        "tracks.delete_range", "Correct", "Delete a range", ("Alt+Del",), selected, submenu="Delete"
    ),
    Command(
        "tracks.delete_frame",
        "Correct",
        "Delete in this frame",
        ("Shift+Del",),
        selected,
        submenu="Delete",
    ),
    Command(
        "tracks.delete_track",
        "Correct",
        "Delete the whole track",
        ("Ctrl+Del",),
        selected,
        submenu="Delete",
    ),
)
_BOX: Final = (
    Command(
        "tracks.draw",
        "Correct",
        "Draw a box",
        ("W",),
        drawable,
        submenu="Draw and move",
        icon="box",
    ),
    Command(
        "tracks.new",
        "Correct",
        "Draw a new person",
        ("Ins",),
        drawable,
        submenu="Draw and move",
        icon="add",
    ),
    Command(
        "tracks.move_box",
        "Correct",
        "Move or resize the box",
        ("V",),
        selected,
        submenu="Draw and move",
    ),
    Command(
        "tracks.move_floor",
        "Correct",
        "Move on the floor",
        ("Shift+V",),
        on_floor,
        submenu="Draw and move",
    ),
)
_KEYFRAMES: Final = (
    Command(
        "tracks.keyframe",
        "Correct",
        "Make this a keyframe",
        ("Shift+W",),
        selected,
        submenu="Keyframes and gaps",
    ),
    Command(
        "tracks.no_keyframe",
        "Correct",
        "Take the keyframe out",
        ("Ctrl+Shift+W",),
        selected,
        submenu="Keyframes and gaps",
    ),
    Command(
        "tracks.thin",
        "Correct",
        "Make keyframes of what was tracked",
        ("Alt+W",),
        selected,
        submenu="Keyframes and gaps",
    ),
    Command(
        "tracks.interpolate",
        "Correct",
        "Interpolate between keyframes",
        ("I",),
        selected,
        submenu="Keyframes and gaps",
        separated=True,
    ),
    Command(
        "tracks.fill_gap",
        "Correct",
        "Fill the gap",
        ("Shift+I",),
        selected,
        submenu="Keyframes and gaps",
    ),
    Command(
        "tracks.fill_gaps",
        "Correct",
        "Fill all gaps",
        ("Ctrl+I",),
        selected,
        submenu="Keyframes and gaps",
    ),
)
_MARK: Final = (
    Command("tracks.occluded", "Correct", "Mark as occluded", ("H",), selected, submenu="Mark as"),
    Command(
        "tracks.visible", "Correct", "Mark as visible", ("Shift+H",), selected, submenu="Mark as"
    ),
    Command("tracks.reviewed", "Correct", "Mark as reviewed", ("Y",), selected, submenu="Mark as"),
)
_WAITING: Final = (
    Command(
        "tracks.confirm",
        "Correct",
        "Do the edit shown",
        ("Return", "Enter"),
        waiting,
        separated=True,
    ),
    Command(
        "tracks.scope",
        "Correct",
        "How far the edit goes",
        ("R",),
        reaching,
        submenu="Change the edit shown",
    ),
    Command(
        "tracks.way",
        "Correct",
        "How the edit is done",
        ("C",),
        waiting,
        submenu="Change the edit shown",
    ),
    Command(
        "tracks.down",
        "Correct",
        "Next proposal, or box down",
        ("Down",),
        waiting,
        submenu="Change the edit shown",
        separated=True,
    ),
    Command(
        "tracks.up",
        "Correct",
        "Previous proposal, or box up",
        ("Up",),
        waiting,
        submenu="Change the edit shown",
    ),
    Command(
        "tracks.far_down",
        "Correct",
        "Box far down",
        ("Shift+Down",),
        placing,
        submenu="Change the edit shown",
    ),
    Command(
        "tracks.far_up",
        "Correct",
        "Box far up",
        ("Shift+Up",),
        placing,
        submenu="Change the edit shown",
    ),
    Command(
        "tracks.taller",
        "Correct",
        "Box taller",
        ("Ctrl+Down",),
        placing,
        submenu="Change the edit shown",
    ),
    Command(
        "tracks.shorter",
        "Correct",
        "Box shorter",
        ("Ctrl+Up",),
        placing,
        submenu="Change the edit shown",
    ),
)
COMMANDS: Final = (*_PEOPLE, *_DELETE, *_BOX, *_KEYFRAMES, *_MARK, *_WAITING)
