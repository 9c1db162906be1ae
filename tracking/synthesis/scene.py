"""A scene in memory: any frame of it, with its truth, without writing a video."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image, StereoFrame
from tracking.synthesis.body import topology
from tracking.synthesis.cast import Cast
from tracking.synthesis.lighting import FloorShade, FloorShadows
from tracking.synthesis.painter import Drawn, Painter, composite
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenery import backdrop
from tracking.synthesis.scenes import SceneSpec
from tracking.synthesis.sensor import Sensor
from tracking.synthesis.truth import SceneTruth, nobody, truth_of

VGA = (640, 480)
FPS = 20.0
"""Size and frame rate of [Kawashita2014]."""

_TRUTH_MARGIN = 1.0


class Scene:
    """A rendered scene; `frame` gives the frames in any order, always the same.

    Attributes:
        spec: what is shown.
        rig: the cameras.
        cast: the people.
        frames: how many frames there are.
        fps: frames a second.
    """

    def __init__(
        self,
        spec: SceneSpec,
        people: int | None = None,
        seed: int = 0,
        *,
        seconds: float | None = None,
        size: tuple[int, int] = VGA,
        fps: float = FPS,
    ) -> None:
        """Plan everybody's way and draw what stands still.

        Args:
            spec: the scene.
            people: how many pass; the scene's own number if None.
            seed: equal seeds give equal pictures.
            seconds: length; the scene's own if None.
            size: width and height of the images in px.
            fps: frames a second.
        """
        self.spec, self.fps = spec, fps
        self.frames = max(round((spec.seconds if seconds is None else seconds) * fps), 1)
        self.rig = Rig.of_scene(spec, size)
        count = spec.people if people is None else people
        self.cast = Cast.of_scene(spec, self.rig, count, self.frames, fps, seed)
        self._triangles = topology()[0]
        self._shadows = FloorShadows(self.rig, spec.lamp)
        self._backdrops = [backdrop(spec, self.rig, eye, seed) for eye in (0, 1)]
        self._painters = [Painter(self.rig, eye, spec.lamp, None) for eye in (0, 1)]
        self._sensors = [Sensor(size, eye, seed) for eye in (0, 1)]

    def frame(self, number: int) -> tuple[StereoFrame, SceneTruth]:
        """Both eyes' pictures of a frame, and what is true in the left one."""
        people = self.cast.on_floor(number)
        if not len(people):
            images = [self._expose(eye, number, None, None) for eye in (0, 1)]
            return self._stereo(number, images), nobody()
        world, normals = self.cast.surfaces(people, number)
        shade = self._shadows.cast(
            world[:, self._triangles].reshape(-1, 3, 3),
            self.cast.posture(people, number).foot.reshape(-1, 2),
        )
        near = self._near(world)
        people, world, normals = people[near], world[near], normals[near]
        light = self._shadows.light_on(world, normals, shade)
        points = self.rig.left_camera_points(world)
        drawn = [
            painter.draw(points, light, self.cast.textures, people, _TRUTH_MARGIN * (eye == 0))
            for eye, painter in enumerate(self._painters)
        ]
        images = [self._expose(eye, number, shade, drawn[eye]) for eye in (0, 1)]
        position = self.cast.posture(people, number).position if len(people) else np.zeros((0, 2))
        truth = truth_of(people, position, self.rig.project(points, 0), drawn[0])
        return self._stereo(number, images), truth

    def _near(self, world: NDArray[np.float64]) -> NDArray[np.intp]:
        """Whose bodies may be seen by an eye."""
        pixels = self.rig.project(self.rig.left_camera_points(world), 0)[..., :2]
        seen = []
        for person, points in enumerate(pixels):
            ahead = points[np.isfinite(points[:, 0])]
            if not len(ahead):
                continue
            low, high = ahead.min(axis=0), ahead.max(axis=0)
            if self.rig.sees(np.concatenate((low, high - low))):
                seen.append(person)
        return np.array(seen, np.intp)

    def _expose(
        self, eye: int, number: int, shade: FloorShade | None, drawn: Drawn | None
    ) -> Image:
        behind = self._backdrops[eye]
        light = behind.light.copy()
        if shade is not None:
            left = self._shadows.seen_by(shade, eye)
            light *= 1.0 - behind.floor * (1.0 - left)
        if drawn is not None:
            composite(light, drawn)
        return self._sensors[eye].expose(light, number)

    def _stereo(self, number: int, images: list[Image]) -> StereoFrame:
        return StereoFrame(number, number / self.fps, images[0], images[1])
