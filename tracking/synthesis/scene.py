"""A scene in memory: any frame of it, with its truth, without writing a video."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image, StereoFrame
from tracking.synthesis.body import topology
from tracking.synthesis.cast import Cast
from tracking.synthesis.lighting import FloorShade, FloorShadows
from tracking.synthesis.painter import FINE, Drawn, Painter, composite
from tracking.synthesis.pillars import Pillars
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenery import backdrop, inverse_depth
from tracking.synthesis.sensor import Sensor
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.truth import (
    SceneTruth,
    Surfaces,
    no_surfaces,
    nobody,
    surfaces_of,
    truth_of,
)

_TRUTH_MARGIN = 1.0


class Scene:
    """A rendered scene; `frame` gives the frames in any order, always the same.

    Attributes:
        spec: what is shown.
        rig: the cameras.
        cast: the people.
        frames: how many frames there are.
        fps: frames a second.
        eyes: 1 or 2.
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
        eyes: int | None = None,
    ) -> None:
        """Plan everybody's way and draw what stands still.

        Args:
            spec: the scene.
            people: how many pass; the scene's own number if None.
            seed: equal seeds give equal pictures.
            seconds: length; the scene's own if None.
            size: width and height of the images in px; the scene's own if None.
            fps: frames a second; the scene's own if None.
            eyes: 2, or 1 for the left eye alone, of the same pictures and truth; the scene's own
                if None.

        Raises:
            SettingsError: the scene is not for so many people.
        """
        size = spec.size_px if size is None else size
        fps, eyes = spec.fps if fps is None else fps, spec.eyes if eyes is None else eyes
        self.spec, self.fps, self.eyes = spec, fps, eyes
        self.frames = max(round((spec.seconds if seconds is None else seconds) * fps), 1)
        self.rig = Rig.of_scene(spec, size)
        count = spec.people if people is None else people
        self.cast = Cast.of_scene(spec, self.rig, count, self.frames, fps, seed)
        self._triangles = topology()[0]
        self._shadows = FloorShadows(self.rig, spec.lamp)
        self._backdrops = [backdrop(spec, self.rig, eye, seed) for eye in range(eyes)]
        self._pillars = Pillars.of_scene(spec)
        self._painters = [
            Painter(self.rig, eye, spec.lamp, self._still(eye)) for eye in range(eyes)
        ]
        self._parts = [behind.split() for behind in self._backdrops]
        self._sensors = [Sensor(size, eye, seed) for eye in range(eyes)]

    def frame(self, number: int) -> tuple[StereoFrame, SceneTruth]:
        """The eyes' pictures of a frame, and what is true in the left one.

        Raises:
            IndexError: there is no such frame.
        """
        people = self._people(number)
        if not len(people):
            return self._stereo(number, self._shade(None, None), [None] * 2), nobody()
        posture = self.cast.posture(people, number)
        world, normals = self.cast.surfaces(people, posture)
        shade = self._shade(world, posture.foot.reshape(-1, 2))
        near = self._near(world)
        people, world = people[near], world[near]
        light = self._shadows.light_on(world, normals[near], shade)
        points = self.rig.left_camera_points(world)
        drawn = [
            painter.draw(points, light, self.cast.textures, people, 0.0 if eye else _TRUTH_MARGIN)
            for eye, painter in enumerate(self._painters)
        ]
        truth = truth_of(people, posture.position[near], self.rig.project(points, 0), drawn[0])
        return self._stereo(number, shade, drawn), truth

    def surfaces(self, number: int) -> Surfaces:
        """Who is seen at which pixel of the left eye, and the true disparity there.

        Raises:
            IndexError: there is no such frame.
        """
        people = self._people(number)
        if not len(people):
            return no_surfaces(self.rig.size)
        world, _ = self.cast.surfaces(people, self.cast.posture(people, number))
        near = self._near(world)
        points = self.rig.left_camera_points(world[near])
        light = np.ones((*points.shape[:2], 2), np.float32)
        drawn = self._painters[0].draw(points, light, self.cast.textures, people[near])
        return surfaces_of(drawn, people[near], self.rig)

    def _people(self, number: int) -> NDArray[np.intp]:
        if not 0 <= number < self.frames:
            raise IndexError(f"frame {number} is not one of the scene's {self.frames}")
        return self.cast.on_floor(number)

    def _still(self, eye: int) -> NDArray[np.float32] | None:
        """Draw the pillars into an eye's backdrop; inverse depth of what people can be behind."""
        walls = inverse_depth(self.spec, self.rig, eye, FINE)
        if not len(self._pillars):
            return walls
        light = self._shadows.light_on(
            self._pillars.vertices, self._pillars.normals, self._shade(None, None)
        )
        behind = self._backdrops[eye]
        pillars = self._pillars.draw(self.rig, eye, self.spec.lamp, light, behind)
        return pillars if walls is None else np.maximum(walls, pillars)

    def _shade(
        self, world: NDArray[np.float64] | None, feet: NDArray[np.float64] | None
    ) -> FloorShade:
        """The shade of pillars and of people, if there are any."""
        corners = self._pillars.corners()
        if world is not None:
            bodies = world[:, self._triangles].reshape(-1, 3, 3)
            corners = np.concatenate((bodies, corners)) if len(corners) else bodies
        return self._shadows.cast(corners, np.zeros((0, 2)) if feet is None else feet)

    def _near(self, world: NDArray[np.float64]) -> NDArray[np.intp]:
        """Whose bodies may be seen by an eye; nobody who is partly behind the camera."""
        pixels = self.rig.project(self.rig.left_camera_points(world), 0)[..., :2]
        seen = []
        for person, points in enumerate(pixels):
            low, high = points.min(axis=0), points.max(axis=0)
            if np.isfinite(low).all() and self.rig.sees(np.concatenate((low, high - low))):
                seen.append(person)
        return np.array(seen, np.intp)

    def _stereo(self, number: int, shade: FloorShade, drawn: Sequence[Drawn | None]) -> StereoFrame:
        left = self._expose(0, number, shade, drawn[0])
        right = self._expose(1, number, shade, drawn[1]) if self.eyes == 2 else None
        return StereoFrame(number, number / self.fps, left, right)

    def _expose(self, eye: int, number: int, shade: FloorShade, drawn: Drawn | None) -> Image:
        floor, rest = self._parts[eye]
        left = self._shadows.seen_by(shade, eye)
        light = np.asarray(cv2.add(cv2.multiply(floor, left), rest), np.float32)
        if drawn is not None:
            composite(light, drawn)
        return self._sensors[eye].expose(light, number)
