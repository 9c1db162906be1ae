"""The commands and their options, in the order in which help lists them.

What a command does stands in the module of its name in `app.cli` and is imported when the command
runs, so that help comes at once and no command waits for libraries it does not use.
"""

# isort: off
from app.cli.commands import recordings, setup, calibration, floor, doctor
from app.cli.commands import trackers, plugins, batch, scores, counts, sessions, desktop

# isort: on
from app.cli.commands.program import program
from app.cli.commands.recordings import SCENE_NAMES

__all__ = [
    "SCENE_NAMES",
    "batch",
    "calibration",
    "counts",
    "desktop",
    "doctor",
    "floor",
    "plugins",
    "program",
    "recordings",
    "scores",
    "sessions",
    "setup",
    "trackers",
]
