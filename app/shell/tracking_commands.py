"""The commands that put trackers to work, and those of the failure detector."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import recording, session
from app.core.commands.conditions import trackable as free_to_track
from app.core.i18n import tr
from app.features.parts.commands import FAILURES, labelled, with_part_truth
from app.shell.again import ask_again, show_runs
from app.shell.window_app import WindowApp


def trackable(app: WindowApp) -> str:
    """A tracker must exist for the recording, and nothing else be going on."""
    if free_to_track(app) or app.open.tracking.best:
        return free_to_track(app)
    return app.open.tracking.why_not


def _tracked(app: WindowApp) -> str:
    """There must be corrected tracks, and a tracker that can go on from them."""
    return session(app) or trackable(app)


def _stoppable(app: WindowApp) -> str:
    """A tracker must be at work, and nobody have stopped it yet."""
    if not app.live:
        return tr("no tracker is running")
    return tr("the tracker is stopping") if app.open.live.stopping else ""


def _trained(app: WindowApp) -> str:
    """A detector must have been trained."""
    return (
        "" if app.files.detectors.result is not None else tr("train a part-failure detector first")
    )


def _in_use(app: WindowApp) -> str:
    """Which detector people are tracked with, where it is not the built-in one."""
    choice = app.files.detectors.choice
    return choice.name if choice.path else ""


TRACK: Final[tuple[Command[WindowApp], ...]] = (
    Command(
        "tracks.track",
        "Track...",
        "Tracks",
        ("Ctrl+T",),
        trackable,
        lambda app: app.files.ask_track(),
        icon="live",
        also="settings parameters tracker plugin plug-in",
    ),
    Command(
        "tracks.stop",
        "Stop tracking, keep the result",
        "Tracks",
        ("Ctrl+Shift+T",),
        _stoppable,
        lambda app: app.open.tracking.stop(),
    ),
    Command(
        "tracks.runs",
        "Runs...",
        "Tracks",
        ("Ctrl+R",),
        session,
        lambda app: show_runs(app.open, app.files.beside.divide, app.files.ask_track),
        also="settings scores results experiments",
    ),
)
AGAIN: Final[tuple[Command[WindowApp], ...]] = (
    Command(
        "review.again",
        "Track again from here...",
        "Review",
        ("Ctrl+Shift+R",),
        _tracked,
        lambda app: ask_again(app.open, app.window.remembered),
        separated=True,
        icon="live",
    ),
)
DETECTOR: Final[tuple[Command[WindowApp], ...]] = (
    *FAILURES,
    Command(
        "detector.suggest",
        "Label where the part-failure detector is least sure",
        "Detector",
        ("Alt+6",),
        labelled,
        lambda app: app.open.labelling.suggest(),
        checked=lambda app: app.document is not None and app.open.labelling.suggests,
        separated=True,
    ),
    Command(
        "detector.truth",
        "Label parts from ground truth",
        "Detector",
        enabled=with_part_truth,
        run=lambda app: app.files.detectors.label_from_truth(),
    ),
    Command(
        "detector.train",
        "Train the part-failure detector...",
        "Detector",
        ("Ctrl+D",),
        recording,
        lambda app: app.files.detectors.ask_train(),
        separated=True,
    ),
    Command(
        "detector.result",
        "Result of the training...",
        "Detector",
        enabled=_trained,
        run=lambda app: app.files.detectors.show_result(),
    ),
    Command(
        "detector.save",
        "Save the trained part-failure detector...",
        "Detector",
        enabled=_trained,
        run=lambda app: app.files.detectors.ask_save(),
    ),
    Command(
        "detector.open",
        "Use a part-failure detector from a file...",
        "Detector",
        enabled=recording,
        run=lambda app: app.files.detectors.ask_open(),
        checked=lambda app: bool(app.files.detectors.choice.path),
        separated=True,
        note=_in_use,
    ),
    Command(
        "detector.built_in",
        "Use the built-in part-failure detector",
        "Detector",
        enabled=recording,
        run=lambda app: app.files.detectors.use_built_in(),
        checked=lambda app: not app.files.detectors.choice.path,
    ),
)
