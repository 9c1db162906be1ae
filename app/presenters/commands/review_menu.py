"""The commands of the Review menu."""

from __future__ import annotations

from typing import Final

from app.presenters.commands.checks import session
from app.presenters.commands.command import Command
from app.presenters.words import tr

COMMANDS: Final = (
    Command(
        "review.score",
        "Review",
        "Score against truth...",
        (),
        lambda now: session(now) or ("" if now.truth else tr("the recording has no truth.txt")),
    ),
)
