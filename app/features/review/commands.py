"""The commands of the review queue."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import WindowState, editable, session, somebody
from app.core.i18n import tr
from app.core.keymap import key_or_title
from app.features.review.controller import ReviewController


def _looked_at(app: WindowState) -> str:
    """A review item must be looked at."""
    if session(app) or app.of(ReviewController).current is not None:
        return session(app)
    return tr("press {key} to go to a review item first", key=key_or_title("review.next"))


def _decidable(app: WindowState) -> str:
    """A review item must be looked at in a session that can be changed."""
    return editable(app) or _looked_at(app)


def _fixable(app: WindowState) -> str:
    """The review item must say what would put it right."""
    if _decidable(app) or app.of(ReviewController).fixable:
        return _decidable(app)
    return tr("no edit is proposed for this item: correct it by hand, or say that it is right")


def _of_many(app: WindowState) -> str:
    """A review item must be looked at that is not the last one."""
    if _decidable(app) or len(app.of(ReviewController).queue.open) > 1:
        return _decidable(app)
    return tr("no other review item is left")


def _watched(app: WindowState) -> str:
    """A stretch must have been watched."""
    if editable(app) or app.of(ReviewController).watching.stretch[1] > 0:
        return editable(app)
    return tr("play a range first")


def _watched_of_some(app: WindowState) -> str:
    """A stretch must have been watched, with somebody selected."""
    return _watched(app) or somebody(app)


def _unflagged(app: WindowState) -> str:
    """No tracker must have made the tracks, and nobody have asked for review items yet."""
    if app.document is not None and app.of(ReviewController).waits:
        return ""
    return session(app) or tr("the tracks are searched already")


def _with_truth(app: WindowState) -> str:
    """There must be tracks, and a ground truth beside the recording."""
    if app.document is not None and app.document.recording.truth_path is not None:
        return session(app)
    return session(app) or tr("the recording has no truth.txt")


COMMANDS: Final[tuple[Command[WindowState], ...]] = (
    Command(
        "review.play",
        "Play the item's range",
        "Review",
        ("Shift+N",),
        _looked_at,
        lambda app: app.of(ReviewController).play(),
    ),
    Command(
        "review.plays",
        "Play each item's range when going to it",
        "Review",
        enabled=session,
        run=lambda app: app.of(ReviewController).set_plays(not app.of(ReviewController).plays),
        checked=lambda app: app.document is not None and app.of(ReviewController).plays,
    ),
    Command(
        "review.search",
        "Look for review items",
        "Review",
        enabled=_unflagged,
        run=lambda app: app.of(ReviewController).look_through(),
    ),
    Command(
        "review.hand_made",
        "Flag hand-made boxes, too",
        "Review",
        enabled=session,
        run=lambda app: app.of(ReviewController).flag_hand_made(
            not app.of(ReviewController).flags_hand_made
        ),
        checked=lambda app: app.document is not None and app.of(ReviewController).flags_hand_made,
        also="quiet labels ground truth imported corrected",
    ),
    Command(
        "review.measure",
        "Measure the queue against ground truth",
        "Review",
        enabled=_with_truth,
        run=lambda app: app.of(ReviewController).set_measures(
            not app.of(ReviewController).measures
        ),
        checked=lambda app: app.document is not None and app.of(ReviewController).measures,
    ),
    Command(
        "review.right",
        "It is right",
        "Review",
        ("Z",),
        _decidable,
        lambda app: app.of(ReviewController).decide("right"),
        separated=True,
    ),
    Command(
        "review.fix",
        "Correct it...",
        "Review",
        ("E",),
        _fixable,
        lambda app: app.of(ReviewController).fix(),
    ),
    Command(
        "review.dismiss",
        "Dismiss it",
        "Review",
        ("Backspace",),
        _decidable,
        lambda app: app.of(ReviewController).decide("dismissed"),
    ),
    Command(
        "review.alike",
        "Decide for all alike...",
        "Review",
        enabled=_of_many,
        run=lambda app: app.of(ReviewController).ask_alike(),
        also="batch many same kind person chance dismiss right",
    ),
    Command(
        "review.mark",
        "Mark what was just watched as reviewed",
        "Review",
        ("Shift+Z",),
        _watched_of_some,
        lambda app: app.of(ReviewController).mark_watched(),
        separated=True,
    ),
    Command(
        "review.mark_all",
        "Mark what was just watched as reviewed for all people",
        "Review",
        ("Alt+Z",),
        _watched,
        lambda app: app.of(ReviewController).mark_watched(everybody=True),
    ),
    Command(
        "review.unmark",
        "Unmark what was just watched",
        "Review",
        enabled=_watched,
        run=lambda app: app.of(ReviewController).unmark_watched(),
    ),
)
