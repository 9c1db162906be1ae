"""The commands that show body parts and walk their failures."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import editable, session
from app.core.commands.view_state import ViewState, panel_command, toggle, view_command
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.features.parts.controller import PartsController
from tracking.trackers import body_part_tracker


def tracked(app: ViewState) -> str:
    """Body parts must have been tracked."""
    if session(app) or app.of(PartsController).presenter.any_tracked:
        return session(app)
    if app.of(PartsController).presenter.tracked_elsewhere:
        return tr(
            "the run being corrected has no parts: correct one that has{key}",
            key=in_brackets("tracks.runs"),
        )
    return tr(
        "no parts were tracked: track with {tracker}{key} first",
        tracker=body_part_tracker(),
        key=in_brackets("tracks.track"),
    )


def labelled(app: ViewState) -> str:
    """Body parts must be there in a session that can be changed."""
    return editable(app) or tracked(app)


def with_part_truth(app: ViewState) -> str:
    """The recording must know exactly where the parts are."""
    if labelled(app) or app.of(PartsController).presenter.truth_known:
        return labelled(app)
    return tr("the recording has no truth_parts.csv: only rendered recordings have one")


def _toggle(app: ViewState, name: str) -> None:
    """Where there is nothing to see, say what to do about it."""
    if toggle(app, name):
        app.of(PartsController).tell_what_is_missing(for_one=name == "part_particles")


def _jump(app: ViewState, step: int) -> None:
    """From failure to failure; parts that were switched off come back, to be seen."""
    if app.of(PartsController).jump(step) and not app.view_options.parts:
        toggle(app, "parts")


VIEWS: Final = (
    view_command(
        "parts",
        "Body parts on the image",
        "View/Body parts",
        ("Q",),
        run=lambda app: _toggle(app, "parts"),
    ),
    view_command(
        "part_particles",
        "Particles of the part on the image",
        "View/Body parts",
        ("Shift+O",),
        run=lambda app: _toggle(app, "part_particles"),
    ),
    panel_command(
        "curves", "Parts over time", "View/Body parts", ("Shift+Q",), also="graph plot curves"
    ),
)
FAILURES: Final[tuple[Command[ViewState], ...]] = (
    Command(
        "detector.next",
        "Next part failure",
        "Detector",
        ("F3",),
        tracked,
        lambda app: _jump(app, 1),
    ),
    Command(
        "detector.previous",
        "Previous part failure",
        "Detector",
        ("Shift+F3",),
        tracked,
        lambda app: _jump(app, -1),
    ),
)
