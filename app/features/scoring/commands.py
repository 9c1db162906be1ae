"""The commands of scoring: the panel, ground truth in the views, walking errors."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import in_the_way, recording
from app.core.commands.view_state import ViewState, panel_command, toggle, view_command
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.features.scoring.controller import ScoreController


def scored(app: ViewState) -> str:
    """Tracks must have been compared with a ground truth."""
    if recording(app) or app.of(ScoreController).known:
        return recording(app)
    return tr(
        "score against ground truth first{key}",
        key=in_brackets("view.score"),
    )


def reportable(app: ViewState) -> str:
    """Tracks must have been compared with a ground truth, or one stand beside the recording.

    Not those that a tracker at work finds: they are others a moment later.
    """
    document = app.document
    if app.busy:
        return tr("wait until the work in progress is done")
    if document is not None and document.shows_further_run:
        return tr(
            "move the playhead to your own tracks, or stop tracking first{key}",
            key=in_brackets("tracks.stop"),
        )
    if app.live and (in_the_way(app) or document is None or document.session is None):
        return tr(
            "stop tracking first{key}",
            key=in_brackets("tracks.stop"),
        )
    if document is not None and document.recording.truth_path is not None and document.tracks.ids:
        return ""
    return scored(app)


def _toggle_score(app: ViewState) -> None:
    """The panel comes and goes with the ground truth it is about."""
    panels = app.view_options.panels ^ {"score"}
    app.view_options = replace(app.view_options, panels=panels, truth="score" in panels)


def _toggle_truth(app: ViewState) -> None:
    """Ground truth and errors, and where there are none why."""
    why = app.of(ScoreController).presenter.why_nothing if toggle(app, "truth") else ""
    if why:
        app.say(why)


def _choose_truth(app: ViewState) -> None:
    """Ask for a file; the score is shown at once, so that the choice is seen."""
    panels = app.view_options.panels | {"score"}
    app.view_options = replace(app.view_options, panels=panels, truth=True)
    app.of(ScoreController).ask_truth()


VIEWS: Final = (
    panel_command(
        "score",
        "Score against ground truth",
        "View/Ground truth and score",
        ("Shift+S",),
        run=_toggle_score,
    ),
    view_command(
        "truth",
        "Ground truth and errors in the views",
        "View/Ground truth and score",
        ("Shift+G",),
        run=_toggle_truth,
    ),
)
ERRORS: Final[tuple[Command[ViewState], ...]] = (
    Command(
        "review.choose_truth",
        "Score against a ground truth file...",
        "Review/Errors against ground truth",
        enabled=recording,
        run=_choose_truth,
        separated=True,
    ),
    Command(
        "review.next_error",
        "Next error against ground truth",
        "Review/Errors against ground truth",
        ("F4",),
        scored,
        lambda app: app.of(ScoreController).walk(1),
    ),
    Command(
        "review.previous_error",
        "Previous error against ground truth",
        "Review/Errors against ground truth",
        ("Shift+F4",),
        scored,
        lambda app: app.of(ScoreController).walk(-1),
    ),
)
