"""An open recording that goes from one window to the next, which is built in another language."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt

from app.core.document.document import Document
from app.core.document.document_loader import OpenedDocument
from app.core.drawing.viewport import Viewport
from app.core.i18n import tr
from app.core.plots.axis import TimeAxis
from app.core.tracks.frame_state import ViewOptions
from app.features.review.controller import ReviewStanding
from app.features.scoring.controller import ScoreController
from app.features.scoring.presenter import ScoringChoice
from tracking.recording import Recording
from tracking.session import Session

if TYPE_CHECKING:
    from app.shell.files import Files
    from app.shell.main_window import MainWindow


@dataclass(frozen=True, slots=True)
class Sight:
    """What the views show: cameras, marks, and the parts of pictures, floor and time in sight.

    `views`: of the left and the right picture and the floor; None: all of it.
    """

    cameras: str
    view_options: ViewOptions
    views: tuple[Viewport | None, ...]
    axis: TimeAxis


@dataclass(frozen=True, slots=True)
class Playing:
    """Where the playhead is, and how it goes on."""

    frame: int
    speed: float
    plays: bool


@dataclass(frozen=True, slots=True)
class OpenWork:
    """All that a window knows of what is open in it. Edits stay in the session, history and all.

    Attributes:
        path: it was opened by. selected: people, the one picked first as the first.
        save_at, settled: see `SaveController`. score: what is scored against what.
    """

    recording: Recording
    session: Session | None
    path: Path
    playing: Playing
    selected: tuple[int, ...]
    sight: Sight
    save_at: Path | None
    settled: object
    score: ScoringChoice
    review: ReviewStanding
    detector_chosen: bool


def why_not_now(window: MainWindow) -> str:
    """What is to end before another window can go on with what is open; "" where nothing is."""
    files, controller = window.files, window.controller
    if window.work.busy or files.keeping.holds:
        return tr("other work is still going on")
    batches = files.projects.batches
    if batches is not None and batches.is_own:
        return tr("a batch is at work")
    if files.setup.dialog is not None or files.doctor.page is not None:
        return tr("a dialog is open")
    if controller is None:
        return ""
    if controller.live.running:
        return tr("the tracker is at work")
    if controller.document.flow is not None:
        return tr("an edit waits to be confirmed or left")
    if controller.comparing.shown or files.beside.shows:
        return tr("a comparison is open")
    if controller.labelling.tool is not None:
        return tr("labels are being drawn")
    return ""


def hand_over(window: MainWindow) -> OpenWork | None:
    """Let the window's recording go, but open; None where there is none."""
    files, controller = window.files, window.controller
    if controller is None:
        return None
    window.workspace.take_typed()
    document, clock = controller.document, controller.playback.clock
    axis, views = window.workspace.timeline.area.stretch.axis, window.workspace.canvases
    sight = Sight(
        controller.cameras, controller.view_options, tuple(one.zoomed_to for one in views), axis
    )
    work = OpenWork(
        document.recording,
        document.session,
        files.whereabouts.opened_by,
        Playing(clock.frame, clock.speed, clock.playing and clock.rate > 0),
        document.selection.all[::-1],
        sight,
        files.saving.proposed,
        files.saving.settled,
        controller.of(ScoreController).presenter.choice,
        controller.reviewing.standing,
        document.detector_chosen,
    )
    files.close(keep_open=True)
    return work


def take_over(files: Files, work: OpenWork) -> None:
    """Go on with a recording that another window let go."""
    document = Document(work.recording, work.session)
    document.detector_chosen = work.detector_chosen
    controller = files.begin(OpenedDocument(work.path, document))
    files.saving.proposed, files.saving.settled = work.save_at, work.settled
    controller.view_options = work.sight.view_options
    controller.of(ScoreController).presenter.choice = work.score
    controller.reviewing.resume(work.review)
    controller.set_cameras(work.sight.cameras)
    files.whereabouts.begin(controller, work.path, from_start=False)
    document.selection.choose_all(work.selected)
    controller.playback.set_speed(work.playing.speed)
    controller.playback.go(work.playing.frame)
    controller.draw()


def look_again(window: MainWindow, work: OpenWork) -> None:
    """Show the same parts of pictures, floor and time, in a window that has its size; play on."""
    controller = window.controller
    if controller is None:
        return
    window.workspace.timeline.area.stretch.show(work.sight.axis)
    views = tuple(zip(window.workspace.canvases, work.sight.views, strict=True))

    def zoom() -> None:
        for canvas, seen in views:
            if seen is not None:
                canvas.look_at(seen)

    zoom()
    if controller.playback.frame is None:  # a picture that comes first is shown whole
        controller.playback.shown.connect(zoom, Qt.ConnectionType.SingleShotConnection)
    if work.playing.plays:
        controller.playback.toggle()
