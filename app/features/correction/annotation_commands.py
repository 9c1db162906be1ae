"""The commands for annotating fast."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, Final

from app.core.commands.command import Command
from app.core.commands.conditions import drawable, selected
from app.core.commands.view_state import view_command
from app.core.editing.annotation_mode import AnnotationMode
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.features.correction.annotation_controller import AnnotationController
from app.features.correction.commands import CorrectionApp

_MENU, _AFTER, _BY_KEYS = "Correct/Annotate", "Correct/After each box", "Correct/Move by keys"


def _mode(app: CorrectionApp) -> AnnotationMode:
    """What is switched on; nothing without a recording."""
    return app.document.correcting.mode if app.document is not None else AnnotationMode()


def _copied(app: CorrectionApp) -> str:
    """A box must have been copied."""
    copied = _mode(app).copied is not None
    return drawable(app) or (
        "" if copied else tr("copy a box first{key}", key=in_brackets("tracks.copy_box"))
    )


def _set_step(app: CorrectionApp, frames: int) -> None:
    app.of(AnnotationController).set_step(frames)


def _goes(app: CorrectionApp, frames: int) -> bool:
    return app.document is not None and _mode(app).step == frames


def _nudge(app: CorrectionApp, by: tuple[int, int], far: bool, resize: bool) -> None:
    app.of(AnnotationController).nudge(*by, far=far, resize=resize)


_STEPS: Final = (
    (0, "Stay in the frame"),
    (1, "Go 1 frame on"),
    (5, "Go 5 frames on"),
    (10, "Go 10 frames on"),
    (25, "Go 25 frames on"),
)


def _steps() -> Iterator[Command[CorrectionApp]]:
    """How far to go on after each box."""
    for frames, title in _STEPS:
        yield Command(
            f"tracks.step_{frames}",
            title,
            _AFTER,
            (),
            drawable,
            partial(_set_step, frames=frames),
            checked=partial(_goes, frames=frames),
        )


_MOVE, _RESIZE = "Ctrl+Shift", "Alt+Shift"
_NUDGES: Final = (
    ("left", (-1, 0), "Left", "Home", "Move the box left", "Move the box 10 pixels left"),
    ("right", (1, 0), "Right", "End", "Move the box right", "Move the box 10 pixels right"),
    ("up", (0, -1), "Up", "PgUp", "Move the box up", "Move the box 10 pixels up"),
    ("down", (0, 1), "Down", "PgDown", "Move the box down", "Move the box 10 pixels down"),
)
_GROWTHS: Final = (
    ("narrower", (-1, 0), "Left", "Home", "Box narrower", "Box 10 pixels narrower"),
    ("wider", (1, 0), "Right", "End", "Box wider", "Box 10 pixels wider"),
    ("lower", (0, -1), "Up", "PgUp", "Box less tall", "Box 10 pixels less tall"),
    ("higher", (0, 1), "Down", "PgDown", "Box taller by its foot", "Box 10 pixels taller"),
)
"""By a pixel with an arrow, by ten with what Fn and that arrow are on small keyboards."""


def _by_keys() -> Iterator[Command[CorrectionApp]]:
    """The selected person's box moved or resized without a preview."""
    for modifier, rows, resize in ((_MOVE, _NUDGES, False), (_RESIZE, _GROWTHS, True)):
        for far in (False, True):
            for name, by, near_key, far_key, near_title, far_title in rows:
                yield Command(
                    f"tracks.box_{name}{'_far' if far else ''}",
                    far_title if far else near_title,
                    _BY_KEYS,
                    (f"{modifier}+{far_key if far else near_key}",),
                    selected,
                    partial(_nudge, by=by, far=far, resize=resize),
                    separated=name in ("left", "narrower") and (resize or far),
                )


def _annotate(
    command: str,
    title: str,
    keys: tuple[str, ...],
    enabled: Callable[[CorrectionApp], str],
    run: Callable[[AnnotationController], object],
    **more: Any,
) -> Command[CorrectionApp]:
    """A command of the submenu that does something by the controller; see `Command`."""
    return Command(
        command,
        title,
        _MENU,
        keys,
        enabled,
        lambda app: run(app.of(AnnotationController)),
        **more,
    )


COMMANDS: Final[tuple[Command[CorrectionApp], ...]] = (
    _annotate(
        "tracks.draw_on",
        "Draw box after box",
        ("Shift+D",),
        drawable,
        AnnotationController.toggle_drawing,
        checked=lambda app: _mode(app).drawing,
        also="annotate repeat continuous again",
    ),
    _annotate(
        "tracks.at_once",
        "Edits without preview",
        ("Shift+P",),
        drawable,
        AnnotationController.toggle_at_once,
        checked=lambda app: _mode(app).at_once,
        also="confirm enter immediately",
    ),
    _annotate(
        "tracks.two_at_once",
        "Edits of two people without preview",
        (),
        drawable,
        AnnotationController.toggle_two_at_once,
        checked=lambda app: _mode(app).two_at_once,
        also="swap merge immediately",
    ),
    _annotate(
        "tracks.copy_box",
        "Copy the box",
        ("Ctrl+C",),
        selected,
        AnnotationController.copy_box,
        separated=True,
    ),
    _annotate(
        "tracks.paste_box",
        "Put the copied box here",
        ("Ctrl+V",),
        _copied,
        AnnotationController.paste_box,
        also="paste",
    ),
    _annotate(
        "tracks.accept_ghost",
        "Put the last box here",
        ("Ctrl+Return", "Ctrl+Enter"),
        selected,
        AnnotationController.accept_ghost,
        also="ghost accept stay",
        separated=True,
    ),
    _annotate(
        "tracks.accept_suggestion",
        "Accept the suggested box",
        ("Shift+Return", "Shift+Enter"),
        drawable,
        AnnotationController.accept_suggestion,
        also="detection take",
    ),
    _annotate(
        "tracks.accept_all",
        "Accept the suggested boxes of everybody",
        ("Ctrl+Shift+Return", "Ctrl+Shift+Enter"),
        drawable,
        AnnotationController.accept_all,
        also="detections take all",
    ),
    _annotate(
        "tracks.dismiss_ghost",
        "Show the last box of this person no more",
        ("Shift+Backspace",),
        drawable,
        AnnotationController.dismiss_ghost,
        also="ghost left gone outside wait",
    ),
    *_steps(),
    *_by_keys(),
)
VIEWS: Final = (
    view_command("suggestions", "Suggested boxes", "View/What the tracker sees", ("Shift+K",)),
)
