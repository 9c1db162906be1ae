"""The body parts of the open document: which is looked at, and what the views show of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.core.document.document import Document
from app.core.scenes.labels import PictureLabels, SuggestedPart
from app.core.scenes.part_curve import LaneScore, PartCurve
from app.core.scenes.pictured_parts import PartBox, PicturedParts
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.parts.cards import cards_of
from app.features.parts.failures import PartFailures
from app.features.parts.part_views import curves_of, curves_scene, part_boxes, with_particles
from app.features.parts.scene import CurvesScene, Failure
from app.features.parts.truth_labels import truth_path
from tracking.session import ids_by_now
from tracking.tracks import Box, Columns, Run

_NO_CURVES: tuple[PartCurve, ...] = ()
_NO_LABELS = PictureLabels()


class PartsPresenter:
    """Makes the scenes of parts; it changes nothing but where the walk of failures is.

    `chosen` tells which part is looked at: the same one that is labelled. `truth_known`: the
    recording says where the parts really are.
    """

    def __init__(self, document: Document, chosen: Callable[[], int]) -> None:
        self._document = document
        self._chosen = chosen
        self.truth_known = truth_path(document.recording) is not None
        self._curves: tuple[Columns | None, tuple[PartCurve, ...]] = (None, _NO_CURVES)
        self._score: LaneScore | None = None
        self._failures: PartFailures | None = None
        self._last: Failure | None = None

    @property
    def run(self) -> Run | None:
        """The run the corrected tracks began as."""
        session = self._document.session
        return None if session is None else session.corrected_run

    @property
    def any_tracked(self) -> bool:
        """Whether the run holds parts at all."""
        run = self.run
        return run is not None and len(run.parts["frame"]) > 0

    @property
    def tracked_elsewhere(self) -> bool:
        """Whether not the run that is corrected, but another one holds parts."""
        session = self._document.session
        if session is None or self.any_tracked:
            return False
        return any(len(run.parts["frame"]) for run in session.runs)

    def picture(
        self,
        state: FrameState,
        view_options: ViewOptions,
        labels: PictureLabels = _NO_LABELS,
        suggested: SuggestedPart | None = None,
    ) -> PicturedParts:
        """What is laid over the left camera.

        Rectangles that are being labelled are drawn by labelling: here is only what the tracker
        says of them. `suggested`: why the part that is looked at is worth labelling.
        """
        labelling = any(one.asked for one in labels.parts)
        boxes: tuple[PartBox, ...] = ()
        if view_options.parts or labelling:
            boxes = part_boxes(state, self._chosen())
        cards = cards_of(boxes, labels.parts, state.selected, state.colours.of, suggested)
        if labelling:
            shown = (box for box in boxes if view_options.parts and not box.selected)
            boxes = tuple(shown)
        parts = PicturedParts(boxes, cards)
        if not view_options.part_particles or not state.selected:
            return parts
        return with_particles(parts, state, self._chosen())

    def curves(self, state: FrameState) -> CurvesScene:
        """The plots of the selected person."""
        recording, curves = self._document.recording, self._curves_now()
        part = self._chosen()
        return curves_scene(state, curves, part, recording.frame_count, recording.fps)

    def score(self) -> LaneScore | None:
        """How the chosen part of the selected person went; None where it was not tracked.

        The very same value as before while nothing changed.
        """
        track, part, curves = self._document.selection.track, self._chosen(), self._curves_now()
        curve = curves[part] if curves else None
        now = self._score
        if curve is None or not len(curve.frames):
            self._score = None
        elif now is None or (now.track, now.part) != (track, part) or now.curve is not curve:
            self._score = LaneScore(track, part, curve)
        return self._score

    def _curves_now(self) -> tuple[PartCurve, ...]:
        """Of the selected person; the same curves as before while their parts are the same."""
        track = self._document.selection.track
        if not track:
            return _NO_CURVES
        rows = self._document.tracks.parts_of_track(track)
        if self._curves[0] is not rows:
            self._curves = (rows, curves_of(rows))
        return self._curves[1]

    def next_failure(self, frame: int, step: int) -> Failure | None:
        """The next (1) or previous (-1) failure of the selected person, or of anybody.

        Where the selected person has no further one, it is somebody else's.
        """
        run, session = self.run, self._document.session
        if run is None or session is None:
            return None
        if self._failures is None or self._failures.parts is not run.parts:
            self._failures, self._last = PartFailures(run.parts), None

        def ids(at: int) -> dict[int, int]:
            return ids_by_now(session.tracks, run, at)

        track = self._document.selection.track
        found = self._failures.walk(frame, step, ids, track, self._last)
        if found is None and track:
            found = self._failures.walk(frame, step, ids, last=self._last)
        self._last = found or self._last
        return found

    def person_box(self, frame: int, track: int) -> Box | None:
        """Around all parts of a person, pixels as recorded; None where they have none there."""
        rows = self._document.tracks.parts(frame)
        mine = rows["track"] == track
        u, v, width, height = (rows[name][mine] for name in ("cx", "cy", "width", "height"))
        known = np.isfinite(u + v + width + height)
        if not known.any():
            return None
        left, top = float((u - width / 2)[known].min()), float((v - height / 2)[known].min())
        right, bottom = float((u + width / 2)[known].max()), float((v + height / 2)[known].max())
        return left, top, right - left, bottom - top
