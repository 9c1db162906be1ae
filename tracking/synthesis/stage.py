"""A scene as the cameras see it in one pose: what stands still, the light, who is drawn."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s, Floats
from tracking.synthesis.body import topology
from tracking.synthesis.cast import Cast
from tracking.synthesis.depth import depth_without_people
from tracking.synthesis.light import FloorShade, FloorShadows
from tracking.synthesis.painter import FINE, Painter, PeopleSamples, composite
from tracking.synthesis.pillars import Pillars
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenery import backdrop, inverse_depth
from tracking.synthesis.skeleton import Posture
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.truth import SceneTruth, Surfaces, surfaces_of, truth_of

_TRUTH_MARGIN = 1.0


class Stage:
    """Draws people who stand where they are told.

    Attributes:
        rig: the cameras.
    """

    def __init__(self, spec: SceneSpec, rig: Rig, cameras: int, seed: int) -> None:
        """Draw what stands still.

        Args:
            spec: the scene.
            rig: the cameras in their pose.
            cameras: 1 or 2.
            seed: equal seeds lay equal floors.
        """
        self.rig, self._spec = rig, spec
        self._triangles = topology()[0]
        self._shadows = FloorShadows(rig, spec.lamp)
        self._backdrops = [backdrop(spec, rig, side, seed) for side in range(cameras)]
        self._pillars = Pillars.of_scene(spec)
        stills = [self._still(side) for side in range(cameras)]
        self._painters = [Painter(rig, side, spec.lamp, still) for side, still in enumerate(stills)]
        self._left_still = stills[0]
        self._depth: Float32s | None = None
        self._parts = [behind.split() for behind in self._backdrops]

    def empty(self) -> list[Float32s]:
        """The light (height, width, 3) that each camera gets of nobody."""
        return self._lights(self._shade(None, None), [None] * len(self._painters))

    def of_people(
        self, cast: Cast, people: NDArray[np.intp], posture: Posture
    ) -> tuple[list[Float32s], SceneTruth]:
        """The light that each camera gets of people (n,), and what is true in the left one."""
        world, normals = cast.surfaces(people, posture)
        shade = self._shade(world, posture.foot.reshape(-1, 2))
        near = self._near(world)
        people, world = people[near], world[near]
        light = self._shadows.light_on(world, normals[near], shade)
        points = self.rig.left_camera_points(world)
        drawn = [
            painter.draw(points, light, cast.textures, people, 0.0 if side else _TRUTH_MARGIN)
            for side, painter in enumerate(self._painters)
        ]
        truth = truth_of(people, posture.position[near], self.rig.project(points, 0), drawn[0])
        return self._lights(shade, drawn), truth

    def surfaces(self, cast: Cast, people: NDArray[np.intp], posture: Posture) -> Surfaces:
        """Who is seen at which pixel of the left camera, and the true disparity there."""
        world, _ = cast.surfaces(people, posture)
        near = self._near(world)
        points = self.rig.left_camera_points(world[near])
        light = np.ones((*points.shape[:2], 2), np.float32)
        drawn = self._painters[0].draw(points, light, cast.textures, people[near])
        return surfaces_of(drawn, people[near], self.rig)

    def depth(self) -> Float32s:
        """(height, width) m along the left camera's axis, with nobody there."""
        if self._depth is None:
            self._depth = depth_without_people(self._spec, self.rig, self._left_still)
        return self._depth

    def _still(self, side: int) -> Float32s | None:
        """Draw the pillars into a camera's backdrop; inverse depth of what people can be behind."""
        walls = inverse_depth(self._spec, self.rig, side, FINE)
        if not len(self._pillars):
            return walls
        light = self._shadows.light_on(
            self._pillars.vertices, self._pillars.normals, self._shade(None, None)
        )
        behind = self._backdrops[side]
        pillars = self._pillars.draw(self.rig, side, self._spec.lamp, light, behind)
        return pillars if walls is None else np.maximum(walls, pillars)

    def _shade(self, world: Floats | None, feet: Floats | None) -> FloorShade:
        """The shade of pillars and of people, if there are any."""
        corners = self._pillars.corners()
        if world is not None:
            bodies = world[:, self._triangles].reshape(-1, 3, 3)
            corners = np.concatenate((bodies, corners)) if len(corners) else bodies
        return self._shadows.cast(corners, np.zeros((0, 2)) if feet is None else feet)

    def _near(self, world: Floats) -> NDArray[np.intp]:
        """Whose bodies may be seen by a camera; nobody who is partly behind the camera."""
        pixels = self.rig.project(self.rig.left_camera_points(world), 0)[..., :2]
        seen = []
        for person, points in enumerate(pixels):
            low, high = points.min(axis=0), points.max(axis=0)
            if np.isfinite(low).all() and self.rig.sees(np.concatenate((low, high - low))):
                seen.append(person)
        return np.array(seen, np.intp)

    def _lights(self, shade: FloorShade, drawn: list[PeopleSamples] | list[None]) -> list[Float32s]:
        return [self._light(side, shade, one) for side, one in enumerate(drawn)]

    def _light(self, side: int, shade: FloorShade, drawn: PeopleSamples | None) -> Float32s:
        floor, rest = self._parts[side]
        left = self._shadows.seen_by(shade, side)
        light = np.asarray(cv2.add(cv2.multiply(floor, left), rest), np.float32)
        if drawn is not None:
            composite(light, drawn)
        return light
