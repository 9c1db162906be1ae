"""Labelling body parts by keys: an answer each, then on to the next part, frame or suggestion."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.editing import EditScope
from app.core.i18n import tr
from app.core.playback.playback import Playback
from app.core.scenes.labels import SuggestedPart
from app.core.scenes.part_names import part_name
from app.features.labelling.part_labeller import PartLabeller
from app.features.labelling.suggestion_search import SuggestionSearch
from tracking.editing import Change
from tracking.errors import EditError
from tracking.tracks import PART_NAMES, Box, PartLabels

Do = Callable[[Callable[[], Change]], bool]
"""Does what is planned; whether it was done."""


class PartKeys(Controller):
    """What is said of the parts of the selected person.

    `changed`: another part, person or scope. Signals: `close_asked(box)`, what is
    suggested is to be seen large: left, top, width, height as recorded, or None for all again.
    """

    close_asked = Signal(object)

    def __init__(
        self,
        document: Document,
        playback: Playback,
        presenter: PartLabeller,
        do: Do,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._playback = document, playback
        self._presenter, self._do = presenter, do
        self._seen = PartLabels()
        self.suggesting = SuggestionSearch(document, self)
        self.suggesting.changed.connect(self._follow)

    @property
    def part(self) -> int:
        """The part that is looked at."""
        return self._presenter.choice.part

    def choose(self, part: int) -> None:
        """Look at a part; the next answer is about it."""
        self._presenter.choice.part = part
        self.said.emit(tr("Part: {part}", part=part_name(part)))
        self.changed.emit()

    def say(self, on_part: bool | None, part: int | None = None) -> None:
        """Say whether a part's rectangle lies on its part, then go on."""
        choice, frame = self._presenter.choice, self._playback.number
        if part is not None:
            choice.part = part
        suggested = self._at_suggested(frame)
        if self._is_said(frame, on_part) or self._do(
            lambda: self._presenter.plan_say(frame, on_part)
        ):
            self._go_on(suggested)

    def _is_said(self, frame: int, on_part: bool | None) -> bool:
        """Whether an answer only goes on, as the same was said already."""
        try:
            return self._presenter.is_said(frame, on_part)
        except EditError:
            return False

    def put_box(self, part: int, box: Box) -> None:
        """A rectangle was drawn, or dragged to where the part is."""
        self._presenter.choice.part = part
        frame = self._playback.number
        suggested = self._at_suggested(frame)
        if self._do(lambda: self._presenter.plan_box(frame, part, box)) and suggested:
            self._go_on(suggested)

    def forget(self) -> None:
        """Take back what was said of the part in the frame, or in the range."""
        self._do(lambda: self._presenter.plan_forget(self._playback.number))

    def set_step(self, frames: int) -> None:
        """Frames to go on after the last part."""
        self._presenter.choice.step = frames

    def next_scope(self) -> None:
        """R: this frame, or the range that is set."""
        self._presenter.next_scope()
        self.changed.emit()

    def choose_scope(self, number: int) -> None:
        """One of both was clicked."""
        if number != self._presenter.scope_row().chosen:
            self.next_scope()

    def _go_on(self, suggested: bool) -> None:
        """To the next suggestion from one of them, else to the next part, and after the last."""
        if suggested:
            self.walk(1)
            return
        choice = self._presenter.choice
        choice.part = (choice.part + 1) % len(PART_NAMES)
        if choice.part == 0 and choice.step and choice.scope is EditScope.FRAME:
            self._playback.step(choice.step)
        self.changed.emit()

    def _at_suggested(self, frame: int) -> bool:
        """Whether what an answer is about now is what was suggested."""
        suggested = self._presenter.choice.suggested
        here = (frame, self._document.selection.track, self.part)
        return suggested is not None and suggested.key == here

    # labels that are taken back

    def see_labels(self, labels: PartLabels) -> None:
        """These are known; what differs afterwards was taken back or done again."""
        self._seen = labels

    def follow_labels(self, labels: PartLabels) -> None:
        """Look again at the person and the part of which something was taken back."""
        seen, self._seen = self._seen, labels
        before, after = ({one.key: one for one in side} for side in seen.unlike(labels))
        keys = [key for key in before | after if before.get(key) != after.get(key)]
        if len({track for _, track, _ in keys}) != 1:
            return
        choice, queue = self._presenter.choice, self.suggesting.queue
        queue.take_labels(labels)
        frame, track, part = min(keys)
        self._document.selection.choose(track)
        if {of for _, _, of in keys} == {part}:
            choice.part = part
        if self.suggesting.asked and len(keys) == 1:
            choice.suggested = queue.return_to(keys[0])
            self._playback.go(frame)
            self.close_asked.emit(self._presenter.person_box(frame))

    # suggestions

    def begin_suggestions(self) -> None:
        """List what is worth labelling, and go to the first as soon as it is found."""
        self.suggesting.look()
        self.changed.emit()

    def end_suggestions(self) -> None:
        """List nothing any more; where something was seen large, all is seen again."""
        self.suggesting.stop()
        suggested, self._presenter.choice.suggested = self._presenter.choice.suggested, None
        if suggested is not None:
            self.close_asked.emit(None)

    def walk(self, step: int) -> None:
        """N (1) or P (-1) while suggestions are walked."""
        session = self._document.session
        if session is not None:
            self.suggesting.queue.take_labels(session.labels.parts)
        self._look_at(self.suggesting.queue.walk(step))

    def go_to(self, number: int) -> None:
        """A suggestion was clicked."""
        self._look_at(self.suggesting.queue.choose(number))

    def _follow(self) -> None:
        """Suggestions were found."""
        queue = self.suggesting.queue
        if queue.open and queue.current is None:
            self._look_at(queue.walk(1))
        else:
            self.changed.emit()

    def _look_at(self, suggested: SuggestedPart | None) -> None:
        choice = self._presenter.choice
        choice.suggested = suggested
        if suggested is None:
            self.said.emit(tr("No suggestions are left to label"))
        else:
            frame, track, choice.part = suggested.key
            choice.scope = EditScope.FRAME
            self._playback.pause()
            self._playback.go(frame)  # first: it may show the session's tracks again
            self._document.selection.choose(track)
            self.close_asked.emit(self._presenter.person_box(frame))
        self.changed.emit()
