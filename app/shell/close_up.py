"""The views closed up on who is concerned, and back."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QRectF, Signal

from app.core.drawing.canvas import Canvas
from app.core.playback.playback import Playback
from app.core.projection.concern import Concern, Part, parts_concerned
from tracking.recording import Recording

_AROUND_S = 1.0
"""So long before and after the frames in question the views stay close."""


class CloseUp(QObject):
    """Shows who is concerned as soon as their frame is there, and all again once it is left.

    A view that the user zooms or moves meanwhile stays as it was left. Signals: `changed()`, it
    begins or ends.
    """

    changed = Signal()

    def __init__(
        self,
        recording: Recording,
        playback: Playback,
        views: tuple[Canvas, Canvas, Canvas],
        wanted: Callable[[], bool],
        parent: QObject,
    ) -> None:
        """Take the views of the left and the right camera, and of the floor.

        wanted: asked for the user's choice; without it the views stay as they are.
        """
        super().__init__(parent)
        self._wanted = wanted
        self._recording, self._playback = recording, playback
        self._views = views
        self._concern: Concern | None = None
        self._waits = False
        self._around = round(_AROUND_S * recording.fps)
        playback.shown.connect(self._follow)
        playback.moved.connect(self._follow)

    @property
    def active(self) -> bool:
        """Whether somebody is looked at closely."""
        return self._concern is not None

    def look_at(self, concern: Concern | None) -> None:
        """Look at people, whose frame may be still to come; None: at nobody any more."""
        if concern is None or not self._wanted() or not len(concern.rows["track"]):
            self.end()
            return
        self._concern, self._waits = concern, True
        if self._is_near(concern):
            self._follow()
        self.changed.emit()

    def end(self) -> None:
        """Show what was shown before."""
        if self._concern is not None:
            self._concern, self._waits = None, False
            for view in self._views:
                view.step_back()
            self.changed.emit()

    def _follow(self) -> None:
        concern = self._concern
        if concern is None:
            return
        if not self._is_near(concern):
            self.end()
        elif self._waits and self._playback.number == self._playback.clock.frame:
            self._waits = False
            self._show(concern)

    def _is_near(self, concern: Concern) -> bool:
        frame = self._playback.clock.frame
        return concern.start - self._around <= frame < concern.end + self._around

    def _show(self, concern: Concern) -> None:
        parts = parts_concerned(self._recording, concern)
        for view, part in zip(self._views, (parts.left, parts.right, parts.floor), strict=True):
            _close_up(view, part)


def _close_up(view: Canvas, part: Part | None) -> None:
    if part is None:
        view.step_back()
    else:
        view.step_close(QRectF(*part))
