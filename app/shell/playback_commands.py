"""The commands of the Playback menu; while an edit waits, some of their keys move it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import WindowState, live, recording
from app.shell.window_app import WindowApp


def _step(app: WindowApp, frames: int) -> None:
    """A frame or ten: moves a box or the cut of an edit that waits, else the playhead."""
    flow = app.open.document.flow
    if flow is not None and flow.places:
        app.open.editing.nudge(1 if frames > 0 else -1, 0, far=abs(frames) > 1)
    elif flow is not None and flow.has_cut and not flow.needs_other:
        app.open.editing.move_cut(frames)
    else:
        app.open.playback.step(frames)


def _second(app: WindowApp, direction: int) -> None:
    """A second; of a box that waits the width, of an edit over a range its end by a frame."""
    flow, playback = app.open.document.flow, app.open.playback
    if flow is not None and flow.places:
        app.open.editing.nudge(direction, 0, resize=True)
    elif flow is not None and flow.has_end:
        app.open.editing.move_end(direction)
    else:
        playback.step(direction * max(1, round(playback.clock.fps)))


def _command(
    name: str,
    title: str,
    key: str,
    run: Callable[[WindowApp], object],
    enabled: Callable[[WindowState], str] = recording,
    *,
    separated: bool = False,
    icon: str = "",
    checked: Callable[[WindowApp], bool] | None = None,
) -> Command[WindowApp]:
    return Command(
        f"play.{name}",
        title,
        "Playback",
        (key,),
        enabled,
        run,
        checked=checked,
        separated=separated,
        icon=icon,
    )


def _speed(name: str, title: str, key: str, steps: int) -> Command[WindowApp]:
    return Command(
        f"play.{name}",
        title,
        "Playback/Speed and loops",
        (key,),
        recording,
        lambda app: app.open.playback.change_speed(steps),
    )


COMMANDS: Final = (
    _command("toggle", "Play or pause", "Space", lambda app: app.open.toggle(), icon="play"),
    _command("next", "Next frame", "Right", lambda app: _step(app, 1), separated=True),
    _command("previous", "Previous frame", "Left", lambda app: _step(app, -1)),
    _command("next10", "Ten frames forward", "Shift+Right", lambda app: _step(app, 10)),
    _command("previous10", "Ten frames back", "Shift+Left", lambda app: _step(app, -10)),
    _command("next_second", "A second forward", "Ctrl+Right", lambda app: _second(app, 1)),
    _command("previous_second", "A second back", "Ctrl+Left", lambda app: _second(app, -1)),
    _command("start", "To the start", "Home", lambda app: app.open.playback.go(0)),
    _command(
        "end",
        "To the end",
        "End",
        lambda app: app.open.playback.go(app.open.playback.clock.last_frame),
    ),
    _command(
        "goto", "Go to frame...", "G", lambda app: app.window.workspace.transport.edit_frame()
    ),
    _command(
        "back",
        "Shuttle back (again: faster)",
        "J",
        lambda app: app.open.shuttle(-1),
        separated=True,
    ),
    _command("stop", "Shuttle stop", "K", lambda app: app.open.shuttle(0)),
    _command("forward", "Shuttle forward (again: faster)", "L", lambda app: app.open.shuttle(1)),
    _command(
        "follow",
        "Follow the running tracker",
        "Shift+L",
        lambda app: app.open.tracking.following.toggle(),
        live,
        separated=True,
        checked=lambda app: app.document is not None and app.open.tracking.following.on,
    ),
    _speed("slower", "Slower", ",", -1),
    _speed("faster", "Faster", ".", 1),
)
