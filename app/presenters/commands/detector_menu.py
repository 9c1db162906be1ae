"""The commands of the Detector menu: labels of parts, training, and which detector is used."""

from __future__ import annotations

from typing import Final

from app.presenters.commands.checks import editable, session
from app.presenters.commands.command import Command, Situation
from app.presenters.words import tr


def _parts(now: Situation) -> str:
    """Body parts must have been tracked."""
    said = tr("no parts were tracked: track with three-part (Ctrl+T) first")
    return session(now) or ("" if now.parts else said)


def _labelled(now: Situation) -> str:
    """Body parts must be there in a session that can be changed."""
    return editable(now) or _parts(now)


COMMANDS: Final = (
    Command("detector.next", "Detector", "Next part failure", ("F3",), _parts),
    Command("detector.previous", "Detector", "Previous part failure", ("Shift+F3",), _parts),
    Command(
        "detector.suggest",
        "Detector",
        "Label where the detector is least sure",
        ("Alt+6",),
        _labelled,
        checkable=True,
        separated=True,
    ),
)
