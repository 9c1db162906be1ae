"""Body parts on the desk: rectangles, particles, plots, the walk from failure to failure."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.presenters.document.document import Document
from app.presenters.document.setting import Instant, Pictured
from app.presenters.parts.parts import PartsPresenter
from app.presenters.parts.parts_scene import PicturedParts
from app.presenters.parts.picturing import part_name
from app.presenters.words import tr
from app.views.desk.workspace import Workspace
from app.views.labelling.labelling import Labelling
from app.views.playing.playback import Playback


class Parts(QObject):
    """Shows the parts that a tracker saw.

    Signals: `changed()`, another person or part is looked at; `said(text)`.
    """

    changed = Signal()
    said = Signal(str)

    def __init__(
        self,
        document: Document,
        playback: Playback,
        workspace: Workspace,
        labelling: Labelling,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._playback = document, playback
        self._workspace, self._labelling = workspace, labelling
        self.presenter = PartsPresenter(document, lambda: labelling.part)
        workspace.curves.frame_sought.connect(playback.go)
        workspace.left.part_picked.connect(labelling.choose_part)

    def close(self) -> None:
        """Leave nothing on the views, which outlive the document."""
        self._workspace.left.show_parts(PicturedParts())
        self._workspace.curves.show_scene(None)

    def draw(self, instant: Instant, pictured: Pictured) -> None:
        """Show an instant."""
        labelling, presenter = self._labelling, self.presenter
        parts = presenter.picture(instant, pictured, labelling.shown, labelling.suggested)
        self._workspace.left.show_parts(parts)
        curves = presenter.curves(instant) if pictured.curves else None
        self._workspace.curves.show_scene(curves)

    def jump(self, step: int) -> None:
        """Go to the next (1) or previous (-1) failure of the selected person, or of anybody."""
        frame = self._playback.clock.frame
        failure = self.presenter.next_failure(frame, step)
        if failure is None:
            self.said.emit(self._no_failure(step))
            return
        self._playback.pause()
        self._document.correcting.leave()
        self._document.selection.choose(failure.track)
        self._labelling.choose_part(failure.part)
        self._playback.go(failure.frame)
        who = self._document.label(failure.track).name
        said = tr("The {part} of {track} begins to fail in frame {frame}")
        if failure.by_rule:
            said = tr(
                "The {part} of {track} begins to fail in frame {frame}, by a rule of the tracker: "
                "its detector had not told so"
            )
        self.said.emit(
            said.format(
                part=part_name(failure.part),
                track=f"{failure.track} {who}".rstrip(),
                frame=failure.frame,
            )
        )
        self.changed.emit()

    def tell_what_is_missing(self, *, whose: bool) -> None:
        """Say why nothing is seen: no parts, or nobody selected for what is one person's."""
        number = self._playback.number
        if not (self.presenter.any_tracked or len(self._document.tracks.parts(number)["part"])):
            self.said.emit(tr("No parts were tracked: track with three-part (Ctrl+T) first"))
        elif whose and not self._document.selection:
            self.said.emit(tr("Click a person to see the particles of their parts"))

    def _no_failure(self, step: int) -> str:
        if not self.presenter.any_tracked:
            return tr("No parts were tracked: track with three-part (Ctrl+T) first")
        track = self._document.selection.track
        whose = tr("of {track}", track=track) if track else tr("of anybody")
        if step > 0:
            return tr("No part {whose} fails after this frame", whose=whose)
        return tr("No part {whose} fails before this frame", whose=whose)
