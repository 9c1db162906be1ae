"""A scene in memory: any frame of it, with its truth, without writing a video."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image, StereoFrame
from tracking.synthesis.cast import Cast
from tracking.synthesis.disturbances import NO_DISTURBANCES, Disturbances, knock_camera
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenario import Moment
from tracking.synthesis.sensor import Sensor
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.stage import Stage
from tracking.synthesis.truth import SceneTruth, Surfaces, no_surfaces, nobody

Floats = NDArray[np.float64]
Float32s = NDArray[np.float32]


class Scene:
    """A rendered scene; `frame` gives the frames in any order, always the same.

    Attributes:
        spec: what is shown.
        rig: the cameras, as they are set up.
        cast: the people; their frames are those of the whole scene, however late it begins.
        frames: how many frames there are.
        fps: frames a second.
        cameras: 1 or 2.
    """

    def __init__(
        self,
        spec: SceneSpec,
        people: int | None = None,
        seed: int = 0,
        *,
        seconds: float | None = None,
        size: tuple[int, int] | None = None,
        fps: float | None = None,
        cameras: int | None = None,
        disturbances: Disturbances = NO_DISTURBANCES,
    ) -> None:
        """Plan everybody's way and draw what stands still.

        Args:
            spec: the scene.
            people: how many pass; the scene's own number if None.
            seed: equal seeds give equal pictures.
            seconds: length; the scene's own, less what is left out of it, if None.
            size: width and height of the images in px; the scene's own if None.
            fps: frames a second; the scene's own if None.
            cameras: 2, or 1 for the left camera alone, of the same pictures and truth; the scene's
                own if None.
            disturbances: what is out of the ordinary.

        Raises:
            SettingsError: the scene is not for so many people.
        """
        size = spec.size_px if size is None else size
        self.fps = spec.fps if fps is None else fps
        self.cameras = spec.cameras if cameras is None else cameras
        self.spec, self._disturbances = spec, disturbances
        self._skipped = round(disturbances.begin_s * self.fps)
        length_s = spec.seconds - disturbances.begin_s if seconds is None else seconds
        self.frames = max(round(length_s * self.fps), 1)
        self.rig = Rig.of_scene(spec, size)
        count = spec.people if people is None else people
        whole = self.frames + self._skipped
        self.cast = Cast.of_scene(spec, self.rig, count, whole, self.fps, seed)
        self._stage = Stage(spec, self.rig, self.cameras, seed)
        self._bumped_stage = self._after_the_knock(size, seed)
        self._sensors = [Sensor(size, side, seed) for side in range(self.cameras)]

    def frame(self, number: int) -> tuple[StereoFrame, SceneTruth]:
        """The cameras' pictures of a frame, and what is true in the left one.

        Raises:
            IndexError: there is no such frame.
        """
        people = self.on_floor(number)
        stage = self._stage_at(number)
        if not len(people):
            return self._exposed(number, stage.empty()), nobody()
        posture = self.cast.posture(people, number + self._skipped)
        lights, truth = stage.of_people(self.cast, people, posture)
        return self._exposed(number, lights), truth

    def surfaces(self, number: int) -> Surfaces:
        """Who is seen at which pixel of the left camera, and the true disparity there.

        Raises:
            IndexError: there is no such frame.
        """
        people = self.on_floor(number)
        if not len(people):
            return no_surfaces(self.rig.size)
        posture = self.cast.posture(people, number + self._skipped)
        return self._stage_at(number).surfaces(self.cast, people, posture)

    def on_floor(self, number: int) -> NDArray[np.intp]:
        """Indices in the cast of who is there in a frame, in view or not.

        Raises:
            IndexError: there is no such frame.
        """
        if not 0 <= number < self.frames:
            raise IndexError(f"frame {number} is not one of the scene's {self.frames}")
        return self.cast.on_floor(number + self._skipped)

    def places(self, number: int) -> Floats:
        """World x, y (n, 2) of who is there in a frame."""
        return self.cast.places(self.on_floor(number), number + self._skipped)

    def moments(self) -> tuple[Moment, ...]:
        """The scenario's moments, in seconds of the recording."""
        late = self._disturbances.begin_s
        return tuple(
            replace(moment, start_s=moment.start_s - late, end_s=moment.end_s - late)
            for moment in self.cast.moments
        )

    def _after_the_knock(self, size: tuple[int, int], seed: int) -> Stage | None:
        if self._disturbances.bumped_s is None:
            return None
        spec = knock_camera(self.spec)
        return Stage(spec, Rig.of_scene(spec, size), self.cameras, seed)

    def _stage_at(self, number: int) -> Stage:
        if self._bumped_stage and self._disturbances.is_bumped(number / self.fps):
            return self._bumped_stage
        return self._stage

    def _exposed(self, number: int, lights: list[Float32s]) -> StereoFrame:
        left = self._expose(0, number, lights[0])
        right = self._expose(1, number, lights[1]) if self.cameras == 2 else None
        return StereoFrame(number, number / self.fps, left, right)

    def _expose(self, side: int, number: int, light: Float32s) -> Image:
        share = self._disturbances.brightness(number / self.fps)
        lit = light if share == 1.0 else light * np.float32(share)
        return self._sensors[side].expose(lit, number)
