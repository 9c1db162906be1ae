"""The flow tracker: points followed, bundled into people, frame by frame."""

from __future__ import annotations

from collections.abc import Iterable

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground import CameraWatch
from tracking.geometry import View
from tracking.people import Observation
from tracking.trackers.flow.body_masks import body_masks
from tracking.trackers.flow.cluster_people import ClusteredPeople
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.flow_frame import POSITIONS, FlowFrame, speeds
from tracking.trackers.flow.foot_lines import foot_lines
from tracking.trackers.flow.kernels import kernel_table
from tracking.trackers.flow.people import HeldPeople
from tracking.trackers.flow.perception import FlowObservation, FlowPerception
from tracking.trackers.flow.point_tracker import PointFollower
from tracking.trackers.flow.result import step_result
from tracking.trackers.flow.resumption import resume_walkers
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.silhouettes import BODY, SHADE
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.tracker_base import TrackerBase
from tracking.translation import Message, msg

_SPACING_PX = (4.0, 24.0)
_BORDER = np.ones((3, 3), np.uint8)


class FlowTracker(TrackerBase[FlowSettings]):
    """Follows people by bundles of tracklets [Yoneji2013].

    With the setting `persistent_points` people keep their tracklets, and the stages of a step are
    those of `HeldPeople.step`; without it they are the paper's, of `ClusteredPeople.step`. Nothing
    is random.
    """

    def __init__(
        self, perception: FlowPerception, view: View, fps: float, settings: FlowSettings
    ) -> None:
        """Nobody is followed yet.

        Args:
            perception: is told where people are. view: the camera over its floor.
            fps: frames a second.
        """
        super().__init__(settings)
        self._perception = perception
        self._view = view
        self._fps = fps
        self._floor = Floor(view)
        box, points = settings.clusters, settings.points
        table = kernel_table(
            view, width_m=box.width_m, height_m=box.height_m, centre_m=box.centre_m
        )
        spacing = np.nan_to_num(table.hx * np.float32(points.spacing), nan=0.0).clip(*_SPACING_PX)
        self._history = max(POSITIONS, round(points.history_s * fps) + 1)
        self._follower = PointFollower(points, self._history, spacing)
        kind = HeldPeople if settings.persistent_points else ClusteredPeople
        self._people: HeldPeople | ClusteredPeople = kind(
            settings, table.scaled(box.bodies), self._floor, self._ids
        )
        self._camera = CameraWatch(fps)

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes for the user, a line each."""
        if self._camera.moved_at is None:
            return ()
        return (
            msg(
                "frame {frame}: the camera was moved: places on the floor, and counts, are wrong "
                "from there on; cut the recording there and measure height and tilt again",
                frame=self._camera.moved_at,
            ),
        )

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected; those who are new get ids above all there were."""
        seen = None
        for observation in observations:
            if observation.frame >= resume.frame - self._history:
                seen = self._measure(observation)
        if seen is not None:
            self._ids.last = resume.highest_track
            self._people.take_over(resume_walkers(resume), seen)

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further: follow points, then the stages, then drop idle points."""
        seen = self._measure(observation)
        self._people.step(seen)
        result = self._report(observation.frame, seen)
        self._drop(seen, self._people.owner)
        if self._perception.learns:
            self._perception.tell(body_masks(self._people.walkers, self._floor))
        return result

    def _report(self, frame: int, seen: FlowFrame) -> StepResult:
        """The frame's result: who has walked, and their tracklets."""
        owner = self._people.owner
        reported = self._people.walkers.select(self._people.walkers.walked)
        shown = np.where(np.isin(owner, reported.track), owner, 0)
        points = seen.tracklets.path[:, 0].astype(np.float64)
        foot_v = foot_lines(points, seen.slope, seen.mask, self._floor)
        return step_result(frame, reported, seen.tracklets, shown, foot_v, self._view)

    def _measure(self, observation: Observation) -> FlowFrame:
        """The frame's tracklets."""
        assert isinstance(observation, FlowObservation), "flow steps on what its perception made"
        assert observation.picture is not None, "perception hands the picture on"
        elapsed_s = self._clock.elapsed_s(observation.time_s)
        grey = np.asarray(cv2.cvtColor(observation.picture, cv2.COLOR_BGR2GRAY), np.uint8)
        self._camera.look(observation.frame, grey)
        mask = observation.mask
        only = self._settings.points.foreground_only
        seek = _solid(mask) if only else self._perception.looked_at_half
        tracklets = self._follower.step(grey, seek)
        return FlowFrame.of(tracklets, mask, elapsed_s, self._fps, self._floor)

    def _drop(self, seen: FlowFrame, owner: NDArray[np.int32]) -> None:
        """Follow no further what is nobody's and hardly moves, or lies in a shadow."""
        speed = speeds(seen.tracklets, self._history, self._fps, self._floor)
        idle = speed < self._settings.points.min_speed_m_s
        if self._settings.points.foreground_only:
            idle |= _on_shadow(seen)
        self._follower.drop((owner == 0) & idle)


def _solid(mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """(rows, columns) non-zero where the foreground is no shadow."""
    return np.asarray(mask == BODY, np.uint8)


def _on_shadow(seen: FlowFrame) -> NDArray[np.bool_]:
    """(n,) tracklets that lie in a shadow, and not at its border with a body."""
    rows, columns = seen.mask.shape
    at = np.nan_to_num(seen.tracklets.path[:, 0] / 2).astype(np.intp)
    u, v = at[:, 0].clip(0, columns - 1), at[:, 1].clip(0, rows - 1)
    near = np.asarray(cv2.dilate(_solid(seen.mask), _BORDER), np.uint8)
    return np.asarray((seen.mask[v, u] == SHADE) & (near[v, u] == 0))
