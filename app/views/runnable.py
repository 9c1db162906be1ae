"""What each command of the catalogue does in the window."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from app.presenters.edit_flow import EditKind, Scope
from app.presenters.words import tr
from app.views.desk import Desk
from app.views.shortcuts import ShortcutsDialog
from app.views.theme import Look

if TYPE_CHECKING:
    from app.views.main_window import MainWindow

Run = Callable[[], None]
OnDesk = Callable[[Desk], object]


def runnable_commands(window: MainWindow) -> dict[str, Run]:
    """For each command of the catalogue what it does."""
    commands = _of_the_window(window)
    for name, run in {**_PLAYING, **_VIEWING, **_CORRECTING}.items():
        commands[name] = _on_desk(window, run)
    return commands


def _on_desk(window: MainWindow, run: OnDesk) -> Run:
    def command() -> None:
        if window.desk is not None:
            run(window.desk)

    return command


def _of_the_window(window: MainWindow) -> dict[str, Run]:
    files, work_space = window.files, window.workspace
    return {
        "file.open": files.ask_open,
        "file.open_folder": files.ask_open_folder,
        "file.demo": files.open_demo,
        "file.save": files.save,
        "file.save_as": files.save_as,
        "file.export_mot": files.export_mot,
        "file.close": files.close_recording,
        "file.quit": window.files.quit,
        "edit.commands": lambda: _open_palette(window),
        "view.look_system": lambda: window.set_look(Look.SYSTEM),
        "view.look_light": lambda: window.set_look(Look.LIGHT),
        "view.look_dark": lambda: window.set_look(Look.DARK),
        "view.next_pane": work_space.focus_next_pane,
        "play.goto": work_space.transport.edit_frame,
        "tracks.track": files.ask_track,
        "tracks.rename": work_space.card.edit_name,
        "review.score": files.score,
        "help.keys": lambda: ShortcutsDialog(window.command_items(), window).open(),
        "help.about": lambda: window.notice.say(
            tr("trackwright: people tracked in recorded stereo footage, corrected and scored.")
        ),
    }


def _open_palette(window: MainWindow) -> None:
    window.palette_of_commands.show_scene(window.command_items())
    window.palette_of_commands.open_over(window)


def _step(frames: int) -> OnDesk:
    """A frame or ten: moves the cut while an edit waits, else the playhead."""

    def step(desk: Desk) -> None:
        flow = desk.document.flow
        if flow is not None and flow.has_cut and not flow.needs_other:
            desk.editing.move_cut(frames)
        else:
            desk.playback.step(frames)

    return step


def _second(direction: int) -> OnDesk:
    """A second; while an edit over a range waits, its end by a frame."""

    def step(desk: Desk) -> None:
        flow = desk.document.flow
        if flow is not None and flow.scope is Scope.RANGE:
            desk.editing.move_end(direction)
        else:
            desk.playback.step(direction * max(1, round(desk.playback.clock.fps)))

    return step


def _toggle(name: str) -> OnDesk:
    def toggle(desk: Desk) -> None:
        now: bool = getattr(desk.pictured, name)
        desk.set_pictured(replace(desk.pictured, **{name: not now}))

    return toggle


def _to_track(end: bool) -> OnDesk:
    def go(desk: Desk) -> None:
        card = desk.document.card()
        if card is not None:
            desk.playback.go(card.last_frame if end else card.first_frame)

    return go


_PLAYING: dict[str, OnDesk] = {
    "play.toggle": Desk.toggle,
    "play.next": _step(1),
    "play.previous": _step(-1),
    "play.next10": _step(10),
    "play.previous10": _step(-10),
    "play.next_second": _second(1),
    "play.previous_second": _second(-1),
    "play.start": lambda desk: desk.playback.go(0),
    "play.end": lambda desk: desk.playback.go(desk.playback.clock.last_frame),
    "play.back": lambda desk: desk.shuttle(-1),
    "play.stop": lambda desk: desk.shuttle(0),
    "play.forward": lambda desk: desk.shuttle(1),
    "play.slower": lambda desk: desk.playback.change_speed(-1),
    "play.faster": lambda desk: desk.playback.change_speed(1),
}
_VIEWING: dict[str, OnDesk] = {
    "view.left": lambda desk: desk.set_eyes("left"),
    "view.both": lambda desk: desk.set_eyes("both"),
    "view.anaglyph": lambda desk: desk.set_eyes("anaglyph"),
    "view.grid": _toggle("grid"),
    "view.particles": _toggle("particles"),
    "view.trails": _toggle("trails"),
    "view.foreground": _toggle("foreground"),
    "view.disparity": _toggle("disparity"),
}
_CORRECTING: dict[str, OnDesk] = {
    "edit.undo": lambda desk: desk.editing.undo(),
    "edit.redo": lambda desk: desk.editing.redo(),
    "tracks.stop": lambda desk: desk.live.stop(),
    "tracks.next": lambda desk: desk.editing.pick_next(1),
    "tracks.previous": lambda desk: desk.editing.pick_next(-1),
    "tracks.none": lambda desk: desk.editing.leave(),
    "tracks.to_start": _to_track(end=False),
    "tracks.to_end": _to_track(end=True),
    "tracks.swap": lambda desk: desk.editing.begin(EditKind.SWAP),
    "tracks.split": lambda desk: desk.editing.begin(EditKind.SPLIT),
    "tracks.merge": lambda desk: desk.editing.begin(EditKind.MERGE),
    "tracks.end_here": lambda desk: desk.editing.begin(EditKind.DELETE),
    "tracks.confirm": lambda desk: desk.editing.confirm(),
    "tracks.scope": lambda desk: desk.editing.next_choice(),
}
