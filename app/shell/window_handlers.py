"""What the commands about files and the window itself do."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.core.i18n import tr
from app.core.look.theme import Look
from app.shell.shortcuts import ShortcutsDialog

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow


def of_the_window(window: MainWindow) -> dict[str, Callable[[], None]]:
    """What commands do that need no open recording, or more of the window than that."""
    files, work_space = window.files, window.workspace
    return {
        "file.open": files.ask_open,
        "file.open_folder": files.ask_open_folder,
        "file.demo": files.open_demo,
        "file.save": files.saving.save,
        "file.save_as": files.saving.save_as,
        "file.import": files.importing.ask,
        "file.export": files.exporting.ask_tracks,
        "file.export_report": files.exporting.ask_report,
        "file.export_counts": files.exporting.ask_counts,
        "file.export_log": files.exporting.ask_log,
        "file.author": files.author.ask,
        "file.restore": files.backups.ask,
        "file.compare": files.beside.ask,
        "file.close": files.close_recording,
        "file.quit": window.files.quit,
        "edit.commands": lambda: _open_palette(window),
        "view.look_system": lambda: window.look_choice.choose(Look.SYSTEM),
        "view.look_light": lambda: window.look_choice.choose(Look.LIGHT),
        "view.look_dark": lambda: window.look_choice.choose(Look.DARK),
        "view.next_pane": work_space.focus_next_pane,
        "play.goto": work_space.transport.edit_frame,
        "tracks.track": files.ask_track,
        "tracks.rename": work_space.card.edit_name,
        "tracks.attributes": work_space.card.edit_attributes,
        "tracks.notes": work_space.card.edit_notes,
        "detector.truth": files.detectors.label_from_truth,
        "detector.train": files.detectors.ask_train,
        "detector.result": files.detectors.show_result,
        "detector.save": files.detectors.ask_save,
        "detector.open": files.detectors.ask_open,
        "detector.built_in": files.detectors.use_built_in,
        "help.keys": lambda: _show_keys(window),
        "help.about": lambda: window.notice.say(
            tr("trackwright: people tracked in recorded stereo footage, corrected and scored.")
        ),
    }


def _show_keys(window: MainWindow) -> None:
    """Not every desktop gives the keys back to the window below once a dialog is closed."""
    dialog = ShortcutsDialog(window.command_items(), window)
    dialog.finished.connect(window.activateWindow)
    dialog.open()


def _open_palette(window: MainWindow) -> None:
    window.palette_of_commands.show_scene(window.command_items())
    window.palette_of_commands.open_over(window)
