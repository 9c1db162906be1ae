"""The commands of the View menu."""

from __future__ import annotations

from typing import Final

from app.presenters.commands.checks import floor, recording, two_eyes
from app.presenters.commands.command import Command

COMMANDS: Final = (
    Command("view.left", "View", "Left eye", ("1",), recording, checkable=True),
    Command("view.both", "View", "Both eyes", ("2",), two_eyes, True),
    Command("view.anaglyph", "View", "Anaglyph (red and cyan)", ("3",), two_eyes, True),
    Command("view.grid", "View", "Floor grid on the picture", ("F",), floor, True, True),
    Command("view.particles", "View", "Particles on the picture", ("O",), recording, True),
    Command("view.trails", "View", "Trails on the picture", ("T",), recording, True),
    Command(
        "view.foreground",
        "View",
        "Foreground and shadows on the picture",
        ("B",),
        lambda now: two_eyes(now) or floor(now),
        True,
    ),
    Command(
        "view.disparity",
        "View",
        "Distances (disparity) on the picture",
        ("D",),
        lambda now: two_eyes(now) or floor(now),
        True,
    ),
    Command("view.labels", "View", "Labels on the picture", ("U",), recording, True),
    Command("view.parts", "View", "Body parts on the picture", ("Q",), recording, True),
    Command(
        "view.part_particles",
        "View",
        "Particles of the part on the picture",
        ("Shift+O",),
        recording,
        True,
    ),
    Command("view.curves", "View", "Parts over time", ("Shift+Q",), recording, True),
    Command(
        "view.time_in",
        "View",
        "Timeline: zoom in",
        ("+", "="),
        recording,
        separated=True,
        submenu="Timeline",
    ),
    Command("view.time_out", "View", "Timeline: zoom out", ("-",), recording, submenu="Timeline"),
    Command(
        "view.time_all",
        "View",
        "Timeline: the whole recording",
        ("0",),
        recording,
        submenu="Timeline",
    ),
    Command(
        "view.time_selected",
        "View",
        "Timeline: the selected track",
        ("Ctrl+0",),
        recording,
        submenu="Timeline",
    ),
    Command(
        "view.time_second",
        "View",
        "Timeline: a second around the playhead",
        ("Alt+0",),
        recording,
        submenu="Timeline",
    ),
    Command(
        "view.time_earlier",
        "View",
        "Timeline: earlier",
        ("Alt+Left",),
        recording,
        submenu="Timeline",
    ),
    Command(
        "view.time_later", "View", "Timeline: later", ("Alt+Right",), recording, submenu="Timeline"
    ),
    Command(
        "view.lanes_up",
        "View",
        "Timeline: tracks further up",
        ("PgUp",),
        recording,
        submenu="Timeline",
    ),
    Command(
        "view.lanes_down",
        "View",
        "Timeline: tracks further down",
        ("PgDown",),
        recording,
        submenu="Timeline",
    ),
    Command("view.next_pane", "View", "To the next part of the window", ("F6",), recording),
    Command(
        "view.look_system",
        "View",
        "Look: as the system",
        (),
        checkable=True,
        separated=True,
        submenu="Look",
    ),
    Command("view.look_light", "View", "Look: light", checkable=True, submenu="Look"),
    Command("view.look_dark", "View", "Look: dark", checkable=True, submenu="Look"),
)
