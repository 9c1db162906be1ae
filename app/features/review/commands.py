"""The commands of the review queue."""

from __future__ import annotations

from typing import Final, Protocol

from app.core.commands.command import Command
from app.core.commands.conditions import WindowState, editable, session, somebody
from app.core.i18n import tr
from app.features.review.controller import ReviewController


class ReviewApp(WindowState, Protocol):
    """What they need of the window."""

    @property
    def reviewing(self) -> ReviewController:
        """Of the open recording."""


def _looked_at(app: ReviewApp) -> str:
    """A review item must be looked at."""
    if session(app) or app.reviewing.current is not None:
        return session(app)
    return tr("press N to go to a review item first")


def _decidable(app: ReviewApp) -> str:
    """A review item must be looked at in a session that can be changed."""
    return editable(app) or _looked_at(app)


def _fixable(app: ReviewApp) -> str:
    """The review item must say what would put it right."""
    if _decidable(app) or app.reviewing.fixable:
        return _decidable(app)
    return tr("no edit is proposed for this item: correct it by hand, or say that it is right")


def _watched(app: ReviewApp) -> str:
    """A stretch must have been watched."""
    if editable(app) or app.reviewing.watching.stretch[1] > 0:
        return editable(app)
    return tr("play a range first")


def _watched_of_some(app: ReviewApp) -> str:
    """A stretch must have been watched, with somebody selected."""
    return _watched(app) or somebody(app)


def _unflagged(app: ReviewApp) -> str:
    """No tracker must have made the tracks, and nobody have asked for review items yet."""
    if app.document is not None and app.reviewing.waits:
        return ""
    return session(app) or tr("the tracks are searched already")


def _with_truth(app: ReviewApp) -> str:
    """There must be tracks, and a ground truth beside the recording."""
    if app.document is not None and app.document.recording.truth_path is not None:
        return session(app)
    return session(app) or tr("the recording has no truth.txt")


COMMANDS: Final[tuple[Command[ReviewApp], ...]] = (
    Command(
        "review.play",
        "Play the item's range",
        "Review",
        ("Shift+N",),
        _looked_at,
        lambda app: app.reviewing.play(),
    ),
    Command(
        "review.plays",
        "Play each item's range when going to it",
        "Review",
        enabled=session,
        run=lambda app: app.reviewing.set_plays(not app.reviewing.plays),
        checked=lambda app: app.document is not None and app.reviewing.plays,
    ),
    Command(
        "review.search",
        "Look for review items",
        "Review",
        enabled=_unflagged,
        run=lambda app: app.reviewing.look_through(),
    ),
    Command(
        "review.measure",
        "Measure the queue against ground truth",
        "Review",
        enabled=_with_truth,
        run=lambda app: app.reviewing.set_measures(not app.reviewing.measures),
        checked=lambda app: app.document is not None and app.reviewing.measures,
    ),
    Command(
        "review.right",
        "It is right",
        "Review",
        ("Z",),
        _decidable,
        lambda app: app.reviewing.decide("right"),
        separated=True,
    ),
    Command(
        "review.fix",
        "Correct it...",
        "Review",
        ("E",),
        _fixable,
        lambda app: app.reviewing.fix(),
    ),
    Command(
        "review.dismiss",
        "Dismiss it",
        "Review",
        ("Backspace",),
        _decidable,
        lambda app: app.reviewing.decide("dismissed"),
    ),
    Command(
        "review.mark",
        "Mark what was just watched as reviewed",
        "Review",
        ("Shift+Z",),
        _watched_of_some,
        lambda app: app.reviewing.mark_watched(),
        separated=True,
    ),
    Command(
        "review.mark_all",
        "Mark what was just watched as reviewed for all people",
        "Review",
        ("Alt+Z",),
        _watched,
        lambda app: app.reviewing.mark_watched(everybody=True),
    ),
    Command(
        "review.unmark",
        "Unmark what was just watched",
        "Review",
        enabled=_watched,
        run=lambda app: app.reviewing.unmark_watched(),
    ),
)
