"""A scene in memory: any frame of it, with its truth, without writing a video."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s, Floats
from tracking.recording.frame import Image, StereoFrame
from tracking.synthesis.cast import Cast
from tracking.synthesis.depth import with_people
from tracking.synthesis.disturbances import NO_DISTURBANCES, Disturbances, knock_camera
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenario import Moment
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.stage import Stage
from tracking.synthesis.truth import SceneTruth, Surfaces, no_surfaces, nobody

_GAINS = (1.0, 0.965)  # the cameras are never quite alike
_OFFSETS = (0.0, 0.4)  # grey levels
_VIGNETTE = 0.09  # darkening in the corners
_READ_NOISE = 0.9  # deviation in the dark, grey levels
_SHOT_NOISE = 0.004  # and what it grows by with each grey level
_BANK = 1 << 18


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

    def depth(self, number: int) -> Float32s:
        """(height, width) m along the left camera's optical axis of what each pixel shows.

        Raises:
            IndexError: there is no such frame.
        """
        return with_people(self._stage_at(number).depth(), self.surfaces(number), self.rig)

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


class Sensor:
    """One camera's sensor."""

    def __init__(self, size: tuple[int, int], side: int, seed: int) -> None:
        """A sensor for images of `size` (width, height); camera 0 is left, 1 right."""
        self._size, self._side, self._seed = size, side, seed
        self._response = self._light_response()
        rng = np.random.default_rng((seed, 77, side))
        # Drawing fresh noise costs more than all the rest: each frame reads this from elsewhere.
        samples = max(_BANK, 3 * self._response.size)
        self._noise = rng.standard_normal(samples, dtype=np.float32)

    def expose(self, light: Float32s, frame: int) -> Image:
        """The 8-bit picture of light (height, width, 3), 0..1 and linear, in a frame."""
        grey = np.asarray(cv2.multiply(light, self._response), np.float32)
        np.sqrt(np.maximum(grey, 0.0, out=grey), out=grey)
        grey *= np.float32(255)
        grey += np.float32(_OFFSETS[self._side])
        rng = np.random.default_rng((self._seed, self._side, frame))
        first = int(rng.integers(0, len(self._noise) - grey.size))
        noise = self._noise[first : first + grey.size].reshape(grey.shape)
        spread = grey * np.float32(_SHOT_NOISE)
        spread += np.float32(_READ_NOISE)
        grey += np.asarray(cv2.multiply(noise, spread), np.float32)
        return np.asarray(cv2.convertScaleAbs(np.maximum(grey, 0.0, out=grey)), np.uint8)

    def _light_response(self) -> Float32s:
        """Gain and vignetting (height, width, 3)."""
        width, height = self._size
        x = np.linspace(-1, 1, width)[None] * width / np.hypot(width, height)
        y = np.linspace(-1, 1, height)[:, None] * height / np.hypot(width, height)
        falloff = _GAINS[self._side] * (1.0 - _VIGNETTE * (x**2 + y**2))
        return np.repeat(falloff.astype(np.float32)[..., None], 3, axis=2)
