"""The commands of the Review menu."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command, CommandContext
from app.core.commands.enablement import editable, recording, scored, session, trackable
from app.core.i18n import tr


def _listed(now: CommandContext) -> str:
    """Something must be left in the queue, or be compared."""
    if now.review_items or now.comparing or now.suggesting:
        return ""
    return session(now) or tr("nothing is left to look at")


def _looked_at(now: CommandContext) -> str:
    """A review item must be looked at."""
    return session(now) or ("" if now.review_item else tr("press N to go to a review item first"))


def _decidable(now: CommandContext) -> str:
    """A review item must be looked at in a session that can be changed."""
    return editable(now) or _looked_at(now)


def _fixable(now: CommandContext) -> str:
    """The review item must say what would put it right."""
    said = tr("this one can only be looked at: correct it by hand, or say that it is right")
    return _decidable(now) or ("" if now.fixable else said)


def _watched(now: CommandContext) -> str:
    """A stretch must have been watched."""
    return editable(now) or ("" if now.watched else tr("play a stretch first"))


def _watched_of_some(now: CommandContext) -> str:
    """A stretch must have been watched, with somebody selected."""
    return _watched(now) or ("" if now.selected else tr("select a person first"))


def _tracked(now: CommandContext) -> str:
    """There must be corrected tracks, and a tracker that can go on from them."""
    return session(now) or trackable(now)


def _unflagged(now: CommandContext) -> str:
    """The tracks must be of no tracker, and not looked through yet."""
    if now.unflagged:
        return ""
    return session(now) or tr("the tracks are looked through already")


def _with_truth(now: CommandContext) -> str:
    """There must be tracks, and a truth beside the recording."""
    return session(now) or ("" if now.truth else tr("the recording has no truth.txt"))


COMMANDS: Final = (
    Command("review.next", "Review", "Next review item", ("N",), _listed),
    Command("review.previous", "Review", "Previous review item", ("P",), _listed),
    Command("review.play", "Review", "Play its stretch", ("Shift+N",), _looked_at),
    Command(
        "review.plays", "Review", "Play each stretch when going to it", (), session, checkable=True
    ),
    Command("review.search", "Review", "Look for doubtful places", (), _unflagged),
    Command(
        "review.measure",
        "Review",
        "Measure the queue against truth",
        (),
        _with_truth,
        checkable=True,
    ),
    Command("review.right", "Review", "It is right", ("Z",), _decidable, separated=True),
    Command("review.fix", "Review", "Put it right...", ("E",), _fixable),
    Command("review.dismiss", "Review", "Dismiss it", ("Backspace",), _decidable),
    Command(
        "review.mark",
        "Review",
        "Mark what was just watched as reviewed",
        ("Shift+Z",),
        _watched_of_some,
        separated=True,
    ),
    Command(
        "review.mark_all",
        "Review",
        "Mark what was just watched as reviewed for all people",
        ("Alt+Z",),
        _watched,
    ),
    Command("review.unmark", "Review", "Unmark what was just watched", (), _watched),
    Command(
        "review.again",
        "Review",
        "Track again from here...",
        ("Ctrl+Shift+R",),
        _tracked,
        separated=True,
        icon="live",
    ),
    Command(
        "review.choose_truth",
        "Review",
        "Score against a truth file...",
        (),
        recording,
        separated=True,
    ),
    Command("review.next_error", "Review", "Next error against the truth", ("F4",), scored),
    Command(
        "review.previous_error",
        "Review",
        "Previous error against the truth",
        ("Shift+F4",),
        scored,
    ),
)
