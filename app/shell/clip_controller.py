"""Clips of the open recording, and its overhead view as a picture."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject
from PySide6.QtGui import QFont

from app.core.controller import Controller
from app.core.i18n import tr
from app.core.look.theme import current_theme
from app.core.tracks.frame_state import FrameState
from app.core.tracks.session_tracks import SessionTracks
from app.core.widgets.questions import choose_new_file
from app.core.widgets.work import Work
from app.features.files.export import refuse_to_lose
from app.features.pictures.clip import ClipChoice, ClipSource
from app.features.pictures.clip_dialog import ClipDialog, ClipOffer, ClipStretch
from app.features.pictures.clip_file import clip_work
from app.features.pictures.floor_picture import SCALE, legible, write_floor
from app.shell.export_controller import beside
from tracking.progress import Progress

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow
    from app.shell.recording_controller import RecordingController

_KEY = "clip"
"""What a clip showed the last time is remembered by."""


class ClipController(Controller):
    """Writes what the views show into files."""

    def __init__(self, window: MainWindow, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = work

    def ask(self) -> None:
        """Ask what a clip is to show, then for a place."""
        controller = self._window.controller
        if controller is None or controller.document.session is None:
            return
        remembered = self._window.remembered
        dialog = ClipDialog(_offer(controller), self._window, remembered.text(_KEY))
        dialog.accepted.connect(lambda: remembered.set_text(_KEY, dialog.remembered))
        dialog.asked.connect(self._ask_place)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _ask_place(self, choice: ClipChoice) -> None:
        controller = self._window.controller
        if controller is None:
            return
        ending = choice.kind.value
        name = f"{controller.document.recording.name}-{choice.start}-{choice.stop - 1}{ending}"
        start = beside(controller.document, name.replace("/", "-"))
        filters = f"{ending[1:].upper()} (*{ending})"
        last = self._window.remembered.last_folder("clip")
        choose_new_file(
            self._window,
            tr("Export a clip"),
            start,
            filters,
            lambda path: self.clip_to(path, choice),
            last,
        )

    def clip_to(self, path: Path, choice: ClipChoice) -> None:
        """Write a clip of what is shown now; what is edited later is not in it."""
        controller = self._window.controller
        if controller is None or controller.document.session is None:
            return
        work = clip_work(_source(controller, self._window.font()), choice, path, refuse_to_lose)
        self._run(path, work)

    def ask_floor(self) -> None:
        """Ask for a place for the overhead view as it is shown now."""
        controller = self._window.controller
        if controller is None or not self._window.workspace.overhead.shows_floor:
            self.said.emit(tr("The overhead view shows no floor"))
            return
        name = f"{controller.document.recording.name}-{controller.playback.number}-overhead.png"
        choose_new_file(
            self._window,
            tr("Export the overhead view"),
            beside(controller.document, name.replace("/", "-")),
            "PNG (*.png);;SVG (*.svg)",
            self.floor_to,
            self._window.remembered.last_folder("clip"),
        )

    def floor_to(self, path: Path) -> None:
        """Write the overhead view as it is shown now: SVG where the name ends so, else PNG."""
        given = self._window.workspace.overhead.given(SCALE, kept=False)
        if given is None:
            return
        theme, shown = current_theme(), legible(given)

        def work(_: Progress) -> None:
            refuse_to_lose(path)
            write_floor(shown, theme, path)

        self._run(path, work)

    def _run(self, path: Path, work: Callable[[Progress], object]) -> None:
        """Write behind all else: it is of tracks that nobody changes."""
        title, told = tr("Exporting {name}", name=path.name), tr("Exported: {path}", path=path)
        self._work.run_behind(title, work, told, path)


def _offer(controller: RecordingController) -> ClipOffer:
    document, recording = controller.document, controller.document.recording
    track = document.selection.track
    person = document.frame_state(controller.playback.number).label(track) if track else ""
    return ClipOffer(
        _stretches(controller, person),
        recording.fps,
        recording.size[1],
        person,
        track,
        recording.is_stereo,
        recording.view is not None,
    )


def _stretches(controller: RecordingController, person: str) -> list[ClipStretch]:
    """The range that is set, the review item's, the selected person's, all; those there are."""
    document, found = controller.document, []
    marked, track = document.correcting.marked, document.selection.track
    count = document.recording.frame_count
    if marked is not None:
        start, stop = max(0, marked[0]), min(count, marked[1])
        name = tr("The range: frames {first} to {last}", first=start, last=stop - 1)
        found.append(ClipStretch(name, start, stop))
    if (item := controller.reviewing.current) is not None:
        start, stop = max(0, item.start), min(count, item.end)
        name = tr("The review item: frames {first} to {last}", first=start, last=stop - 1)
        found.append(ClipStretch(name, start, stop))
    if track:
        frames = document.tracks.of_track(track)["frame"]
        if len(frames):
            start, stop = int(frames[0]), int(frames[-1]) + 1
            name = tr(
                "Person {person}: frames {first} to {last}",
                person=person,
                first=start,
                last=stop - 1,
            )
            found.append(ClipStretch(name, start, stop, track))
    whole = tr("The whole recording: {count} frames", count=count)
    return [*found, ClipStretch(whole, 0, count)]


def _source(controller: RecordingController, font: QFont) -> ClipSource:
    """Takes hold of all that is drawn; edits from now on are not in it."""
    document, session = controller.document, controller.document.session
    assert session is not None
    tracks = SessionTracks(session.tracks.snapshot(), session.corrected_run)
    frame, now = controller.playback.frame, document.corrected_state(controller.playback.number)
    still = FrameState(
        now.frame,
        tracks,
        dict(now.names),
        selected=document.selection.track,
        also=document.selection.also,
        run=session.corrected_run,
        colours=now.colours.copy(),
    )
    return ClipSource(
        document.recording,
        0 if frame is None or frame.right_lag is None else frame.right_lag,
        tracks,
        still,
        controller.view_options,
        controller.scenes.overhead.bounds,
        controller.markers(),
        controller.floor_markers(),
        current_theme(),
        QFont(font),
    )
