"""Another person's session beside the open one: opened, compared, drawn, walked through."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.core.i18n import N_, tr
from app.core.projection.concern import Concern
from app.core.projection.other_people import OtherPeople
from app.core.scenes import Side
from app.core.scenes.other_people import Divider
from app.core.widgets.questions import choose_file
from app.core.widgets.work import Work
from app.features.comparison.agreement import (
    AgreementPresenter,
    OtherSession,
    compare_again,
    read_other,
)
from tracking.errors import TrackwrightError

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow
    from app.shell.recording_controller import RecordingController

_SESSIONS = N_("trackwright (*.h5)")


class SessionsBeside(QObject):
    """Shows another session of the same recording beside the one that is open."""

    def __init__(self, window: MainWindow, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = work
        self._shown: AgreementPresenter | None = None
        self._share: float | None = None
        for picture in (window.workspace.left, window.workspace.right):
            picture.divider_moved.connect(self.divide)
        panel = window.workspace.compare
        panel.stretch_sought.connect(self._go)
        panel.again_asked.connect(self._again)
        panel.theirs_asked.connect(self._take_theirs)
        panel.left.connect(self.close)

    @property
    def shows(self) -> bool:
        """Whether another session is shown."""
        return self._shown is not None

    def ask(self) -> None:
        """Ask for the other session."""
        choose_file(
            self._window,
            tr("Another session of this recording"),
            tr(_SESSIONS),
            self.compare_with,
            self._window.remembered.last_folder("open"),
        )

    def compare_with(self, path: Path) -> None:
        """Read another session in the background and show where it disagrees."""
        controller = self._window.controller
        if controller is None or controller.document.session is None:
            return
        session, runs = controller.document.session, controller.comparing.shown
        work = partial(read_other, path, session, session.tracks.snapshot())
        title = tr("Comparing with {name}", name=path.name)
        self._work.run(title, lambda report: work(report), partial(self._show, controller, runs))

    def close(self) -> None:
        """Show nobody else's people any more."""
        self._shown = None
        self.draw()

    @property
    def compares(self) -> bool:
        """Whether two versions are compared: of runs, or of two people."""
        controller = self._window.controller
        runs = controller is not None and controller.comparing.shown
        return runs or self._shown is not None

    @property
    def share(self) -> float | None:
        """How much of the pictures is left of the divider; None: there is none."""
        return self._share

    def divide(self, share: float | None) -> None:
        """Draw one version left of a line through the pictures and the other one right of it."""
        self._share = None if share is None else min(max(share, 0.0), 1.0)
        self.draw()

    def _divider(self, controller: RecordingController) -> Divider | None:
        if self._share is None:
            return None
        if controller.comparing.dashed is not None:
            left, right = controller.comparing.versions
        else:
            left = tr("this session")
            right = self._shown.other.name if self._shown is not None else ""
        return Divider(self._share, left, right)

    def draw(self) -> None:
        """Draw other people at the frame that is shown; those of a compared run go first."""
        controller, shown = self._window.controller, self._shown
        if not self.compares:
            self._share = None
        if controller is not None and controller.comparing.shown:
            self._shown = shown = None  # the pictures show the runs: a panel beside them misleads
        session = controller.document.session if controller is not None else None
        panel = shown.panel(session.tracks.revision) if shown and session is not None else None
        self._window.workspace.compare.show_scene(panel)
        compared = controller.comparing.dashed if controller is not None else None
        self._draw_people(controller, compared or (shown.people if shown and panel else None))

    def _draw_people(
        self, controller: RecordingController | None, people: OtherPeople | None
    ) -> None:
        """Draw a run's or the other session's people, dashed; None: nobody else's."""
        view = self._window.workspace
        if controller is None or people is None:
            for picture in (view.left, view.right):
                picture.show_others(())
                picture.show_divider(None)
            view.overhead.show_others(())
            return
        frame, divider = controller.playback.number, self._divider(controller)
        for picture in (view.left, view.right):
            picture.show_divider(divider)
        view.left.show_others(people.picture(Side.LEFT, frame))
        view.right.show_others(
            people.picture(Side.RIGHT, frame) if controller.cameras == "both" else ()
        )
        view.overhead.show_others(people.floor(frame))

    def _show(self, controller: RecordingController, runs: bool, other: OtherSession) -> None:
        """Show what was found; runs: they were compared when it was asked for."""
        if controller is not self._window.controller:
            return
        if controller.comparing.shown and not runs:  # begun meanwhile: it is being looked at
            said = tr("Runs are being compared: compare with {name} again", name=other.name)
            self._window.say(said)
            return
        self._shown = AgreementPresenter(
            controller.document.recording, other, controller.document.colour_of
        )
        controller.comparing.close()  # one comparison at a time
        self.draw()

    def _again(self) -> None:
        controller, shown = self._window.controller, self._shown
        if controller is None or shown is None or controller.document.session is None:
            return
        session = controller.document.session
        work = partial(compare_again, shown.other, session, session.tracks.snapshot())
        title = tr("Comparing with {name}", name=shown.other.name)
        self._work.run(title, lambda report: work(report), partial(self._show, controller, False))

    def _take_theirs(self, number: int) -> None:
        """Take the other person's word in one disagreement, as one edit; then compare again."""
        controller, shown = self._window.controller, self._shown
        if controller is None or shown is None or controller.document.session is None:
            return
        document = controller.document
        document.correcting.leave()
        try:
            change = shown.plan_theirs(number, controller.document.session.tracks)
            document.apply(change)
        except TrackwrightError as error:
            controller.editing.failed.emit(error)
            return
        controller.editing.said.emit(tr("Done: {what}", what=change.text))
        controller.draw()
        self._again()

    def _go(self, frame: int, track: int) -> None:
        controller = self._window.controller
        if controller is None:
            return
        controller.playback.pause()
        session = controller.document.session
        if session is not None:
            known = [track] if track in session.tracks else []
            rows = session.tracks.of_tracks(known, frame, frame + 1)
            controller.close_up.look_at(Concern(rows, frame, frame + 1))
        controller.playback.go(frame)  # first: it may show the session's tracks again
        if track and controller.document.flow is None:
            controller.document.selection.choose(track)
        controller.draw()
