"""The commands of the review queue."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

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


def _command(
    command: str,
    title: str,
    keys: tuple[str, ...],
    enabled: Callable[[WindowState], str],
    run: Callable[[ReviewController], object],
    **more: Any,
) -> Command[WindowState]:
    """A command of the menu that does something by the controller; see `Command`."""
    return Command(
        command, title, "Review", keys, enabled, lambda app: run(app.of(ReviewController)), **more
    )


def _switch(
    command: str,
    title: str,
    enabled: Callable[[WindowState], str],
    is_on: Callable[[ReviewController], bool],
    put: Callable[[ReviewController, bool], object],
    **more: Any,
) -> Command[WindowState]:
    """A command of the menu that switches something on and off; see `Command`."""
    return _command(
        command,
        title,
        (),
        enabled,
        lambda review: put(review, not is_on(review)),
        checked=lambda app: app.document is not None and is_on(app.of(ReviewController)),
        **more,
    )


COMMANDS: Final[tuple[Command[WindowState], ...]] = (
    _command(
        "review.play",
        "Play the item's range",
        ("Shift+N",),
        _looked_at,
        ReviewController.play,
    ),
    _switch(
        "review.plays",
        "Play each item's range when going to it",
        session,
        lambda review: review.plays,
        ReviewController.set_plays,
    ),
    _command(
        "review.search", "Look for review items", (), _unflagged, ReviewController.look_through
    ),
    _switch(
        "review.hand_made",
        "Flag hand-made boxes, too",
        session,
        lambda review: review.flags_hand_made,
        ReviewController.flag_hand_made,
        also="quiet labels ground truth imported corrected",
    ),
    _switch(
        "review.measure",
        "Measure the queue against ground truth",
        _with_truth,
        lambda review: review.measures,
        ReviewController.set_measures,
    ),
    _command(
        "review.right",
        "It is right",
        ("Z",),
        _decidable,
        lambda review: review.decide("right"),
        separated=True,
    ),
    _command("review.fix", "Correct it...", ("E",), _fixable, ReviewController.fix),
    _command(
        "review.dismiss",
        "Dismiss it",
        ("Backspace",),
        _decidable,
        lambda review: review.decide("dismissed"),
    ),
    _command(
        "review.alike",
        "Decide for all alike...",
        (),
        _of_many,
        ReviewController.ask_alike,
        also="batch many same kind person chance dismiss right",
    ),
    _command(
        "review.mark",
        "Mark what was just watched as reviewed",
        ("Shift+Z",),
        _watched_of_some,
        ReviewController.mark_watched,
        separated=True,
    ),
    _command(
        "review.mark_all",
        "Mark what was just watched as reviewed for all people",
        ("Alt+Z",),
        _watched,
        lambda review: review.mark_watched(everybody=True),
    ),
    _command(
        "review.unmark",
        "Unmark what was just watched",
        (),
        _watched,
        ReviewController.unmark_watched,
    ),
)
