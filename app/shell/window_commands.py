"""The commands of files and of the window itself, and those that several features share."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import (
    drawable,
    editable,
    floor,
    pending,
    recording,
    replaceable,
    savable,
    session,
)
from app.core.i18n import tr
from app.core.look.theme import Look
from app.core.scenes.labels import Tool
from app.features.history.controller import HistoryWalk
from app.features.scoring.commands import reportable
from app.shell import project_commands
from app.shell.language_choice import SYSTEM, name_of_language
from app.shell.shortcuts import ShortcutsDialog
from app.shell.window_app import WindowApp
from tracking.translation import languages, msg

_LOOK = "look colours"
_LANGUAGE = "language English Japanese translation \u65e5\u672c\u8a9e"


def _file(
    name: str,
    title: str,
    keys: tuple[str, ...],
    enabled: Callable[[WindowApp], str],
    run: Callable[[WindowApp], object],
    *,
    separated: bool = False,
    icon: str = "",
) -> Command[WindowApp]:
    return Command(
        f"file.{name}", title, "File", keys, enabled, run, separated=separated, icon=icon
    )


def _at_any_time(_: WindowApp) -> str:
    return ""


FILES: Final = (
    _file(
        "open", "Open...", ("Ctrl+O",), _at_any_time, lambda app: app.files.ask_open(), icon="open"
    ),
    _file(
        "open_folder",
        "Open folder...",
        ("Ctrl+Shift+O",),
        _at_any_time,
        lambda app: app.files.ask_open_folder(),
    ),
    *project_commands.COMMANDS,
    Command[WindowApp](
        "file.setup",
        "Set up a recording...",
        "File",
        (),
        _at_any_time,
        lambda app: app.files.setup.ask(),
        also="calibration floor cameras pair videos metres",
    ),
    Command[WindowApp](
        "file.setup_again",
        "Set up this recording...",
        "File",
        (),
        recording,
        lambda app: app.files.setup.again(),
        also="calibration floor height tilt metres overhead again",
    ),
    _file(
        "save",
        "Save",
        ("Ctrl+S",),
        savable,
        lambda app: app.files.saving.save(),
        separated=True,
        icon="save",
    ),
    _file(
        "save_as", "Save as...", ("Ctrl+Shift+S",), savable, lambda app: app.files.saving.save_as()
    ),
    _file("restore", "Restore a backup...", (), replaceable, lambda app: app.files.backups.ask()),
    _file(
        "import",
        "Import tracks...",
        ("Ctrl+Shift+I",),
        drawable,
        lambda app: app.files.importing.ask(),
        separated=True,
    ),
    _file(
        "export",
        "Export tracks...",
        ("Ctrl+E",),
        session,
        lambda app: app.files.exporting.ask_tracks(),
        icon="export",
    ),
    Command[WindowApp](
        "file.export_clip",
        "Export a clip...",
        "File/Export for others",
        ("Ctrl+Shift+E",),
        session,
        lambda app: app.files.clips.ask(),
        also="video mp4 gif movie film overlays",
    ),
    Command[WindowApp](
        "file.export_floor",
        "Export the overhead view...",
        "File/Export for others",
        (),
        floor,
        lambda app: app.files.clips.ask_floor(),
        also="picture png svg image floor map",
    ),
    _file(
        "export_report",
        "Export a score report...",
        (),
        reportable,
        lambda app: app.files.exporting.ask_report(),
    ),
    Command[WindowApp](
        "file.export_counts",
        "Export counts...",
        "File/Export for others",
        (),
        session,
        lambda app: app.files.exporting.ask_counts(),
    ),
    Command[WindowApp](
        "file.export_log",
        "Export the edit history...",
        "File/Export for others",
        (),
        session,
        lambda app: app.files.exporting.ask_log(),
    ),
    _file(
        "compare",
        "Compare with another session...",
        (),
        session,
        lambda app: app.files.beside.ask(),
    ),
    Command[WindowApp](
        "view.jobs",
        "List of jobs...",
        "File",
        ("Ctrl+J",),
        _at_any_time,
        lambda app: app.window.show_jobs(),
        also="running finished work progress cancel background queue",
    ),
    _file(
        "close",
        "Close recording",
        ("Ctrl+W",),
        recording,
        lambda app: app.files.close_recording(),
        separated=True,
    ),
    _file("quit", "Quit", ("Ctrl+Q",), _at_any_time, lambda app: app.files.quit()),
)


def _open_palette(app: WindowApp) -> None:
    app.window.palette_of_commands.show_scene(app.window.registry.items())
    app.window.palette_of_commands.open_over(app.window)


def _show_keys(app: WindowApp) -> None:
    """Not every desktop gives the keys back to the window below once a dialog is closed."""
    dialog = ShortcutsDialog(app.window.registry.items(), app.window)
    dialog.finished.connect(app.window.activateWindow)
    dialog.finished.connect(dialog.deleteLater)
    dialog.change_asked.connect(app.window.key_choice.edit)
    dialog.open()


def _tell_about(app: WindowApp) -> None:
    app.window.notice.say(
        tr("trackwright: people tracked in recorded stereo footage, corrected and scored.")
    )


def _look(look: Look, title: str, *, separated: bool = False) -> Command[WindowApp]:
    return Command(
        f"view.look_{look.value}",
        title,
        "Edit/Theme",
        run=lambda app: app.window.look_choice.choose(look),
        checked=lambda app: app.window.look_choice.look is look,
        separated=separated,
        also=_LOOK,
    )


def _language(language: str, title: str) -> Command[WindowApp]:
    return Command(
        f"view.language_{language or 'system'}",
        title,
        "View/Language",
        run=lambda app: app.window.language_choice.choose(language),
        checked=lambda app: app.window.language_choice.language == language,
        also=_LANGUAGE,
    )


EDIT: Final[tuple[Command[WindowApp], ...]] = (
    Command(
        "edit.undo_alone",
        "Undo only the chosen edit",
        "Edit",
        ("Ctrl+Alt+Z",),
        editable,
        lambda app: app.of(HistoryWalk).undo_alone(),
    ),
    Command(
        "edit.commands",
        "Search commands...",
        "Edit",
        ("Ctrl+K",),
        run=_open_palette,
        separated=True,
        icon="search",
    ),
    Command(
        "edit.keys",
        "Keys...",
        "Edit",
        run=lambda app: app.window.key_choice.edit(),
        also="shortcuts profile cvat sleap change rebind",
        separated=True,
    ),
    Command(
        "file.author",
        "Your name in the history...",
        "Edit",
        run=lambda app: app.files.author.ask(),
    ),
)
LAYOUT: Final = (
    Command[WindowApp](
        "view.whole",
        "Show the whole image and floor",
        "View/Zoom",
        ("Shift+A",),
        recording,
        lambda app: app.window.workspace.show_whole(),
        also="zoom fit all",
        separated=True,
    ),
    _look(Look.SYSTEM, "Theme: as the system", separated=True),
    _look(Look.LIGHT, "Theme: light"),
    _look(Look.DARK, "Theme: dark"),
    _language(SYSTEM, "Language: as the system"),
    *(_language(one, msg("Language: {name}", name=name_of_language(one))) for one in languages()),
)
HELP: Final[tuple[Command[WindowApp], ...]] = (
    Command("help.keys", "All shortcuts", "Help", ("F1",), run=_show_keys),
    Command(
        "help.doctor",
        "Check this recording...",
        "Help",
        (),
        recording,
        lambda app: app.files.doctor.ask(),
        also="doctor calibration floor lag mend wrong",
    ),
    Command(
        "file.demo", "Try the demo", "Help", run=lambda app: app.files.open_demo(), icon="demo"
    ),
    Command("help.about", "About trackwright", "Help", run=_tell_about),
)

# what several features share


def _to_leave(app: WindowApp) -> str:
    """There must be a selection, an edit or a label to leave."""
    document = app.document
    if document is not None and (
        document.selection
        or document.flow is not None
        or document.correcting.mode.drawing
        or app.open.labelling.tool is not None
        or app.open.close_up.active
    ):
        return ""
    return tr("nobody is selected")


def _scoped(app: WindowApp) -> str:
    """Something must be done that has a scope: an edit that waits, labels of parts."""
    labels = app.document is not None and app.open.labelling.tool is Tool.PARTS
    return "" if labels else pending(app)


def _next_scope(app: WindowApp) -> None:
    """R: the scope of the edit that waits, else an answer about a body part."""
    if app.open.document.flow is None and app.open.labelling.tool is Tool.PARTS:
        app.open.labelling.next_scope()
    else:
        app.open.editing.next_choice(0)


def _listed(app: WindowApp) -> str:
    """Something must be left in the queue, or be compared."""
    if app.document is not None and (
        app.open.reviewing.lists_items or app.open.comparing.shown or app.open.labelling.suggests
    ):
        return ""
    return session(app) or tr("no review items are left")


def _walk(app: WindowApp, step: int) -> None:
    """N and P: through what differs while two versions are compared, else through the queue.

    While parts are labelled where the detector is least sure: through these.
    """
    if app.open.comparing.shown:
        app.open.comparing.walk(step)
    elif app.open.labelling.suggests:
        app.open.labelling.walk(step)
    else:
        app.open.reviewing.walk(step)


LEAVE: Final[tuple[Command[WindowApp], ...]] = (
    Command(
        "tracks.none",
        "Select nobody, cancel the edit",
        "Tracks",
        ("Esc",),
        _to_leave,
        lambda app: app.open.leave(),
    ),
)
SCOPE: Final[tuple[Command[WindowApp], ...]] = (
    Command(
        "tracks.scope",
        "Scope of the edit",
        "Correct/Change the edit shown",
        ("R",),
        _scoped,
        _next_scope,
    ),
)
WALK: Final[tuple[Command[WindowApp], ...]] = (
    Command(
        "review.next", "Next review item", "Review", ("N",), _listed, lambda app: _walk(app, 1)
    ),
    Command(
        "review.previous",
        "Previous review item",
        "Review",
        ("P",),
        _listed,
        lambda app: _walk(app, -1),
    ),
)
