"""People from one camera: a frame in, an observation out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from copy import deepcopy

import cv2
import numpy as np

from tracking.arrays import Floats, Mask
from tracking.foreground import (
    PERHAPS,
    BackgroundModel,
    ForegroundSettings,
    ShadeColour,
    ShadowRemover,
    Subtraction,
)
from tracking.geometry import View
from tracking.people import upright
from tracking.people.body_scale import Standing
from tracking.people.box_bodies import working_boxes
from tracking.people.box_regions import join_regions, measure_from_boxes, regions_of_boxes
from tracking.people.detection_source import DetectionSource
from tracking.people.detections import Detections
from tracking.people.ghosts import without_ghosts
from tracking.people.horizon import Horizon, fit_horizon
from tracking.people.observation import Observation, Overlays
from tracking.people.region_features import described, in_full
from tracking.people.regions_of_people import people_regions
from tracking.people.settings import PeopleSettings
from tracking.people.silhouettes import AnyLabels, Labels
from tracking.people.working_scale import shrink_of, shrunk
from tracking.recording.frame import Image, StereoFrame
from tracking.translation import Message, count_msg, msg

_NEAREST = cv2.INTER_NEAREST
_PROTECTED = np.ones((17, 17), np.uint8)
"""Round people the background is not learnt."""
_AROUND_BOXES = np.ones((5, 5), np.uint8)
"""What borders on a body in a box is part of it."""


class SingleCameraPerception:
    """Turns pictures of one fixed camera, or of the left camera of two, into people.

    Args:
        fps: frames a second of the recording.
        view: the camera over its floor; None: nothing is known in metres.
        foreground, people: settings; None for the usual ones.
        boxes: of another program's detector; None: people are seen by the foreground alone.
        looked_at: (height, width) non-zero where people are looked for in the left picture as
            recorded; None: everywhere.
    """

    stereo_watch: None = None
    """It looks with one camera."""

    def __init__(
        self,
        fps: float,
        view: View | None = None,
        foreground: ForegroundSettings | None = None,
        people: PeopleSettings | None = None,
        boxes: DetectionSource | None = None,
        looked_at: Mask | None = None,
    ) -> None:
        self._background = BackgroundModel(fps, foreground, looked_at)
        self._shadows = ShadowRemover(foreground)
        self._shade = ShadeColour()
        self._view = view
        self._settings = people or PeopleSettings()
        self._boxes = boxes
        self._shrink = 1
        self._horizon: Horizon | None = None
        self._left_out = 0

    @property
    def notes(self) -> tuple[Message, ...]:
        """Where the horizon is, of a camera that is not calibrated, and who was left out by it."""
        horizon = self._horizon
        if horizon is None:
            return ()
        return (
            msg(
                "horizon from people's heights: row {row:.0f} (± {sd:.0f} px) at the left edge; "
                "{regions} above it or of no person's size left out",
                row=horizon.row(0.0),
                sd=horizon.row_sd(0.0),
                regions=count_msg(self._left_out, "{n} region", "{n} regions"),
            ),
        )

    def learn(self, frames: Iterable[StereoFrame], later: Iterable[StereoFrame] = ()) -> None:
        """Learn the background from frames spread over some time, before the first `observe`.

        Not needed, but it spares the ghosts of people who stand in the very first frames.

        Args:
            later: of each the frame a moment later, which tells what moves.
        """
        frames = list(frames)
        pictures, after = ([self._working(each.left) for each in some] for some in (frames, later))
        self._background.learn(pictures, after, [frame.time_s for frame in frames])
        if self._view is None:
            self._horizon = fit_horizon(self._bodies(frames))

    def _bodies(self, frames: Sequence[StereoFrame]) -> Floats:
        """(n, 4) px boxes of whole bodies in the foreground of some frames."""
        boxes, kept = [np.zeros((0, 4))], (self._background, self._shade)
        # Both follow light and shade; the first frame is to find them as they were learnt.
        self._background, self._shade = deepcopy(self._background), ShadeColour()
        for frame in frames:
            self._shrink = shrink_of(frame.left.shape[1])
            seen = self._background.subtract(self._working(frame.left))
            standing = Standing(None, self._shrink, self._settings)
            kind = self._kinds(seen, self._shadows.shadows(seen))
            given = np.zeros_like(kind)
            regions = join_regions(given, self._beside(seen, kind, given, standing))
            people = described(regions, seen.picture, frame.left.shape, standing, self._settings)
            boxes.append(people.box[~people.truncated])
        self._background, self._shade = kept
        return np.concatenate(boxes)

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order."""
        image = frame.left
        self._shrink = shrink_of(image.shape[1])
        seen = self._background.subtract(self._working(image), frame.time_s)
        shadow = self._shadows.shadows(seen)
        standing = Standing(self._view, self._shrink, self._settings)
        kind = self._kinds(seen, shadow)
        given, boxes = self._given(frame.number, kind)
        regions = join_regions(given, self._beside(seen, kind, given, standing))
        people = described(regions, seen.picture, image.shape, standing, self._settings)
        people = measure_from_boxes(people, boxes, standing, self._shrink)
        people = self._of_size(people)
        self._remember(seen, regions)
        overlays = self._overlays(seen.mask, shadow, image)
        return Observation(frame.number, frame.time_s, people, overlays, image)

    def _of_size(self, people: Detections) -> Detections:
        """The people without regions of the foreground that the horizon does not allow."""
        if self._horizon is None or not len(people):
            return people
        kept = self._horizon.allows(people.box) | people.from_detector | people.truncated
        self._left_out += int((~kept).sum())
        return people if kept.all() else people.chosen(kept)

    def _given(self, frame: int, kind: Mask) -> tuple[Labels, Floats]:
        """The regions of the boxes given, and these boxes (n, 4) as recorded."""
        none = np.zeros_like(kind), np.zeros((0, 4))
        if self._boxes is None or not len(boxes := self._boxes.of(frame).box):
            return none
        labels, shown = regions_of_boxes(working_boxes(boxes, self._shrink), kind)
        return labels, boxes[shown]

    def _beside(self, seen: Subtraction, kind: Mask, given: Labels, standing: Standing) -> Labels:
        """The regions of people in the foreground that no box explains."""
        if self._boxes is not None and self._boxes.detections_only:
            return np.zeros_like(kind)
        if given.any():
            kind = np.where(cv2.dilate(given, _AROUND_BOXES) > 0, np.uint8(0), kind)
        regions = people_regions(kind, standing)
        known = self._view is not None
        return without_ghosts(regions, seen.picture, seen.background, floor_known=known)

    def overlays(self, frame: StereoFrame) -> Overlays:
        """What a view may lay over a frame; nothing is remembered, frames come in any order."""
        seen = self._background.subtract(self._working(frame.left))
        return self._overlays(seen.mask, self._shadows.shadows(seen), frame.left)

    def _kinds(self, seen: Subtraction, shadow: Mask) -> Mask:
        """(height, width) the foreground in the kinds of `tracking.people.upright`, else 0."""
        self._shade.follow(seen, shadow)
        kind = seen.mask.copy()
        like = cv2.resize(self._like_shade(seen, shadow), kind.shape[::-1], interpolation=_NEAREST)
        kind[cv2.bitwise_and(like, kind) > 0] = upright.PERHAPS
        kind[shadow == PERHAPS] = upright.PERHAPS
        kind[shadow == 255] = upright.SHADOW
        return kind

    def _like_shade(self, seen: Subtraction, shadow: Mask) -> Mask:
        """(rows, columns) 255 where foreground has the colour of shade, at half resolution."""
        v, u = np.nonzero(seen.mask[::2, ::2] & ~shadow[::2, ::2])
        like = np.zeros(seen.mask[::2, ::2].shape, np.uint8)
        like[v, u] = np.where(self._shade.alike(seen, 2 * v, 2 * u), 255, 0)
        return like

    def _remember(self, seen: Subtraction, regions: AnyLabels) -> None:
        """Let the background follow what was seen, except where people are."""
        if self._background.update_is_due:
            people = cv2.dilate((regions > 0).view(np.uint8), _PROTECTED)
            self._background.update(seen, np.asarray(people, np.uint8))
        else:
            self._background.update(seen)

    def _working(self, image: Image) -> Image:
        """The camera at the working scale."""
        return shrunk(image, shrink_of(image.shape[1]))

    def _overlays(self, mask: Mask, shadow: Mask, image: Image) -> Overlays:
        shown = np.where(shadow == 255, np.uint8(127), mask)
        return Overlays(in_full(shown, image.shape), None)
