"""All commands of the window, in the order of their menus."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.features.correction import annotation_commands as annotation
from app.features.correction import attribute_commands as attributes
from app.features.correction import commands as correction
from app.features.labelling import commands as labelling
from app.features.pictures import commands as pictures
from app.features.review import commands as review
from app.features.scoring import commands as scoring
from app.features.timeline import commands as timeline
from app.shell import (
    divider_commands,
    layout_commands,
    loop_commands,
    playback_commands,
    tracking_commands,
    window_commands,
)
from app.shell.features import FEATURES
from app.shell.window_app import WindowApp

COMMANDS: Final[tuple[Command[WindowApp], ...]] = (
    *window_commands.FILES,
    *correction.HISTORY,
    *window_commands.EDIT,
    *pictures.CAMERAS,
    *pictures.OVERLAYS,
    *labelling.VIEWS,
    *(command for feature in FEATURES for command in feature.commands),
    *annotation.VIEWS,
    *pictures.ONE_CAMERA,
    *timeline.COMMANDS,
    *divider_commands.COMMANDS,
    *window_commands.LAYOUT,
    *layout_commands.COMMANDS,
    *playback_commands.COMMANDS,
    *loop_commands.COMMANDS,
    *tracking_commands.TRACK,
    *correction.NEXT,
    *window_commands.LEAVE,
    *correction.SELECTED,
    *attributes.COMMANDS,
    *correction.CORRECT,
    *annotation.COMMANDS,
    *correction.CONFIRM,
    *window_commands.SCOPE,
    *correction.CHANGE,
    *labelling.COMMANDS,
    *window_commands.WALK,
    *review.COMMANDS,
    *tracking_commands.AGAIN,
    *scoring.ERRORS,
    *tracking_commands.DETECTOR,
    *window_commands.HELP,
)
