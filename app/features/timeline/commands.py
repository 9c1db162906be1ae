"""The commands of the timeline."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Protocol

from app.core.commands.command import Command
from app.core.commands.conditions import WindowState, recording
from app.features.timeline.tracks_area import TracksArea


class TimelineApp(WindowState, Protocol):
    """What they need of the window."""

    @property
    def lanes(self) -> TracksArea:
        """The lanes of the tracks."""


def _command(
    name: str,
    title: str,
    keys: tuple[str, ...],
    act: Callable[[TracksArea], None],
    *,
    separated: bool = False,
) -> Command[TimelineApp]:
    return Command(
        f"view.{name}",
        title,
        "View/Timeline",
        keys,
        recording,
        lambda app: act(app.lanes),
        separated=separated,
    )


COMMANDS: Final = (
    _command(
        "time_in",
        "Timeline: zoom in",
        ("+", "="),
        lambda area: area.stretch.zoom(2.0),
        separated=True,
    ),
    _command("time_out", "Timeline: zoom out", ("-",), lambda area: area.stretch.zoom(0.5)),
    _command(
        "time_all", "Timeline: the whole recording", ("0",), lambda area: area.stretch.show_all()
    ),
    _command(
        "time_selected",
        "Timeline: the selected track",
        ("Ctrl+0",),
        lambda area: area.stretch.show_selected(),
    ),
    _command(
        "time_second",
        "Timeline: a second around the playhead",
        ("Alt+0",),
        lambda area: area.stretch.show_second(),
    ),
    _command(
        "time_earlier", "Timeline: earlier", ("Alt+Left",), lambda area: area.stretch.pan(-0.5)
    ),
    _command("time_later", "Timeline: later", ("Alt+Right",), lambda area: area.stretch.pan(0.5)),
    _command(
        "lanes_up", "Timeline: tracks further up", ("PgUp",), lambda area: area.lanes.scroll(-8)
    ),
    _command(
        "lanes_down",
        "Timeline: tracks further down",
        ("PgDown",),
        lambda area: area.lanes.scroll(8),
    ),
)
