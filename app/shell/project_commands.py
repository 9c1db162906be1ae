"""The commands of a project: opened, walked through, tracked as a batch, compared, learnt from."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import recording
from app.core.i18n import tr
from app.shell.window_app import WindowApp


def _command(
    name: str,
    title: str,
    keys: tuple[str, ...],
    enabled: Callable[[WindowApp], str],
    run: Callable[[WindowApp], object],
    also: str = "",
) -> Command[WindowApp]:
    return Command(f"file.{name}", title, "File/Project", keys, enabled, run, also=also)


def _at_any_time(_: WindowApp) -> str:
    return ""


def _project(app: WindowApp) -> str:
    """A project must be open."""
    return "" if app.files.projects.is_open else tr("open a project first")


def _in_project(app: WindowApp) -> str:
    """A recording must be open, and the project behind it."""
    return _project(app) or recording(app)


def _may_track(app: WindowApp) -> str:
    """A project must be open, and no batch be at work in it."""
    return _project(app) or ("" if _batch(app) else tr("a batch is at work: wait, or stop it"))


def _batch(app: WindowApp) -> str:
    """A batch must be at work."""
    return "" if app.files.projects.is_batch_at_work else tr("no batch is at work")


def _comparable(app: WindowApp) -> str:
    """A project must be open in which two annotators worked on one recording."""
    if app.busy or _project(app):
        return _project(app) or tr("wait until the work in progress is done")
    several = app.files.projects.project.compared
    return "" if several else tr("no recording of the project has two sessions")


def _trainable(app: WindowApp) -> str:
    """A project must be open in which body parts are labelled."""
    if app.busy or _project(app):
        return _project(app) or tr("wait until the work in progress is done")
    labelled = app.files.projects.project.labelled
    return "" if labelled else tr("no session of the project has labels of body parts")


def _has_next(app: WindowApp) -> str:
    """A project must be open in which something is left to review."""
    return _project(app) or app.files.projects.project.why_not_next


COMMANDS: Final = (
    _command(
        "open_project",
        "Open project...",
        ("Ctrl+Alt+O",),
        _at_any_time,
        lambda app: app.files.projects.ask(),
        also="folder recordings batch list",
    ),
    _command(
        "project",
        "Back to the project",
        ("Ctrl+Alt+P",),
        _in_project,
        lambda app: app.files.projects.back(),
        also="list recordings close",
    ),
    _command(
        "next_recording",
        "Next recording to review",
        ("Ctrl+Alt+N",),
        _has_next,
        lambda app: app.files.projects.project.open_next(),
        also="project risk worth",
    ),
    _command(
        "track_project",
        "Track recordings...",
        (),
        _may_track,
        lambda app: app.files.projects.ask_batch(),
        also="batch project",
    ),
    _command(
        "stop_batch",
        "Stop the batch",
        (),
        _batch,
        lambda app: app.files.projects.project.batches.cancel(),
        also="cancel project",
    ),
    _command(
        "agreement",
        "Agreement between annotators...",
        (),
        _comparable,
        lambda app: app.files.projects.compare(),
        also="project kappa compare",
    ),
    _command(
        "train_project",
        "Train a part-failure detector from all sessions...",
        (),
        _trainable,
        lambda app: app.files.projects.train(),
        also="project labels",
    ),
    _command(
        "close_project",
        "Close project",
        (),
        _project,
        lambda app: app.files.projects.close_project(),
    ),
)
