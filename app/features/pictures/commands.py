"""The commands that choose cameras and what lies over the pictures."""

from __future__ import annotations

from typing import Final, Protocol

from app.core.commands.command import Command
from app.core.commands.conditions import floor, recording, two_cameras, two_cameras_and_floor
from app.core.commands.view_state import ViewState, toggle, view_command
from app.core.tracks.frame_state import FrameState
from app.features.pictures.bodies import why_nothing


class PicturesApp(ViewState, Protocol):
    """What they need of the window."""

    cameras: str
    """"left", "both" or "anaglyph"; setting it lays the pictures out anew."""

    @property
    def frame_state(self) -> FrameState:
        """The frame as it is shown."""


def _show(mode: str, app: PicturesApp) -> None:
    app.cameras = mode


def _toggle_bodies(app: PicturesApp, name: str) -> None:
    """Of what trackers of one camera think of; where there is nothing to see, say why."""
    why = why_nothing(app.frame_state, name) if toggle(app, name) else ""
    if why:
        app.say(why)


def _cameras(mode: str, app: PicturesApp) -> bool:
    return app.document is not None and app.cameras == mode


CAMERAS: Final[tuple[Command[PicturesApp], ...]] = (
    Command(
        "view.left",
        "Left camera",
        "View",
        ("1",),
        recording,
        lambda app: _show("left", app),
        checked=lambda app: _cameras("left", app),
        title_one_camera="Image",
    ),
    Command(
        "view.both",
        "Both cameras",
        "View",
        ("2",),
        two_cameras,
        lambda app: _show("both", app),
        checked=lambda app: _cameras("both", app),
    ),
    Command(
        "view.anaglyph",
        "Anaglyph (red and cyan)",
        "View",
        ("3",),
        two_cameras,
        lambda app: _show("anaglyph", app),
        checked=lambda app: _cameras("anaglyph", app),
    ),
)
OVERLAYS: Final = (
    view_command("grid", "Floor grid on the image", "View", ("F",), floor, separated=True),
    view_command("particles", "Particles on the image", "View/What the tracker sees", ("O",)),
    view_command("trails", "Trails on the image", "View", ("T",)),
    view_command(
        "foreground",
        "Foreground and shadows on the image",
        "View/What the tracker sees",
        ("B",),
        two_cameras_and_floor,
    ),
    view_command(
        "disparity",
        "Distances (disparity) on the image",
        "View/What the tracker sees",
        ("D",),
        two_cameras_and_floor,
    ),
    view_command("region", "Region of interest on the image", "View/What the tracker sees"),
    view_command("floor_legend", "Legend on the floor", "View", (), floor),
    view_command(
        "close_up",
        "Zoom to who is concerned",
        "View/Zoom",
        also="review item error difference closer enlarge",
        separated=True,
    ),
)
ONE_CAMERA: Final = (
    view_command(
        "tracklets",
        "Tracklets and kernel on the image",
        "View/One camera",
        ("Shift+T",),
        run=lambda app: _toggle_bodies(app, "tracklets"),
    ),
    view_command(
        "outlines",
        "Outlines of hypotheses on the image",
        "View/One camera",
        ("Shift+E",),
        floor,
        lambda app: _toggle_bodies(app, "outlines"),
    ),
    view_command(
        "evaluation",
        "Region of evaluation on the image",
        "View/One camera",
        ("Shift+R",),
        floor,
        lambda app: _toggle_bodies(app, "evaluation"),
    ),
    view_command("ramp", "Ramp on the image", "View/One camera", ("Shift+B",), floor),
)
