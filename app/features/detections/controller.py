"""Detections of another program: read in the background, drawn over the pictures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import Qt

from app.core.feature import FeatureContext, FeatureController, Marker, ShownFrame
from app.core.i18n import tr
from app.core.jobs.latest_job import LatestJob
from app.core.scenes import Side
from app.core.scenes.detections import NO_DETECTIONS
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.detections.presenter import (
    UsedDetections,
    boxes_of,
    network_of,
    network_picture,
    picture,
)
from tracking.detections import RecordingDetections
from tracking.errors import SettingsError
from tracking.progress import Progress

_Found = tuple[UsedDetections, RecordingDetections | None]


class DetectionsController(FeatureController):
    """Draws the boxes that the tracker of what is shown was given.

    `marked`: they have been read.
    """

    def __init__(self, context: FeatureContext, _: None = None) -> None:
        super().__init__(context.parent)
        self._document, self._surfaces = context.document, context.surfaces
        self._found: _Found | None = None
        self._search = LatestJob(tr("Reading detections"), self._prepare, self, cancellable=False)
        self._search.found.connect(self._take)
        self._search.failed.connect(lambda _, error: self.failed.emit(error))
        self._search.changed.connect(self.marked, Qt.ConnectionType.QueuedConnection)

    def close(self) -> None:
        """End the thread; leave nothing on the views, which outlive the document."""
        self._search.stop()
        self._show(None, 0, None)

    def draw_frame(self, shown: ShownFrame) -> None:
        """Show a frame; what is missing for it is read."""
        network = network_of(shown.state.run) if shown.view_options.detections else ""
        if network:
            self._show_network(shown, network)
            return
        given = _used_detections(shown.state) if shown.view_options.detections else None
        if given is not None:
            self._search.ask(given)
        known = self._found is not None and self._found[0] == given
        boxes = self._found[1] if self._found is not None and known else None
        self._show(boxes, shown.state.frame, shown.right if shown.cameras == "both" else None)

    def marker(self, view_options: ViewOptions) -> Marker | None:
        """The boxes, as far as they have been read by now."""
        if not view_options.detections:
            return None
        found = self._found[1] if self._found is not None else None

        def mark(marks: PictureMarks, side: Side, state: FrameState, number: int) -> PictureMarks:
            if network := network_of(state.run):
                return replace(marks, detections=network_picture(state, network, side))
            if found is None:
                return marks
            return replace(marks, detections=picture(found, side, number))

        return mark

    def _show_network(self, shown: ShownFrame, network: str) -> None:
        """The boxes that a network found for what is shown; the right camera where it is seen."""
        left = network_picture(shown.state, network, Side.LEFT)
        right = NO_DETECTIONS
        if shown.cameras == "both" and shown.right is not None:
            right = network_picture(shown.state, network, Side.RIGHT)
        self._surfaces.left.show_detections(left)
        self._surfaces.right.show_detections(right)

    def _show(self, boxes: RecordingDetections | None, left: int, right: int | None) -> None:
        """The boxes of these frames of the cameras; None: none."""
        pictured = [NO_DETECTIONS, NO_DETECTIONS]
        if boxes is not None:
            pictured[0] = picture(boxes, Side.LEFT, left)
            if right is not None:
                pictured[1] = picture(boxes, Side.RIGHT, right)
        self._surfaces.left.show_detections(pictured[0])
        self._surfaces.right.show_detections(pictured[1])

    def _prepare(self, given: UsedDetections) -> Callable[[Progress], _Found]:
        recording = self._document.recording
        return lambda _: (given, boxes_of(recording, given))

    def _take(self, found: _Found) -> None:
        self._found = found


def _used_detections(state: FrameState) -> UsedDetections | None:
    try:
        return UsedDetections.of(state.run)
    except SettingsError:
        return None  # made by another version
