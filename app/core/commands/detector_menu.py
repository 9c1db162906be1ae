"""The commands of the Detector menu: labels of parts, training, and which detector is used."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command, CommandContext
from app.core.commands.enablement import editable, recording, session
from app.core.i18n import tr


def _parts(now: CommandContext) -> str:
    """Body parts must have been tracked."""
    said = tr("no parts were tracked: track with three-part (Ctrl+T) first")
    if now.parts_elsewhere:
        said = tr("the run being corrected has no parts: correct one that has (Ctrl+R)")
    return session(now) or ("" if now.parts else said)


def _labelled(now: CommandContext) -> str:
    """Body parts must be there in a session that can be changed."""
    return editable(now) or _parts(now)


def _part_truth(now: CommandContext) -> str:
    """The recording must know exactly where the parts are."""
    said = tr("the recording has no truth_parts.csv: only rendered recordings have one")
    return _labelled(now) or ("" if now.part_truth else said)


def _trained(now: CommandContext) -> str:
    """A detector must have been trained."""
    return "" if now.trained else tr("train a detector first")


def _in_use(now: CommandContext) -> str:
    """Which detector people are tracked with, where it is not the built-in one."""
    return now.detector


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
    Command("detector.truth", "Detector", "Label parts from the truth", (), _part_truth),
    Command(
        "detector.train",
        "Detector",
        "Train the detector...",
        ("Ctrl+D",),
        recording,
        separated=True,
    ),
    Command("detector.result", "Detector", "Result of the training...", (), _trained),
    Command("detector.save", "Detector", "Save the trained detector...", (), _trained),
    Command(
        "detector.open",
        "Detector",
        "Use a detector from a file...",
        (),
        recording,
        checkable=True,
        separated=True,
        now=_in_use,
    ),
    Command(
        "detector.built_in",
        "Detector",
        "Use the built-in detector",
        (),
        recording,
        checkable=True,
    ),
)
