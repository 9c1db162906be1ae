"""Everybody in a scene: ways, steps, bodies and clothes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s, Floats
from tracking.errors import SettingsError
from tracking.synthesis import marks, situations
from tracking.synthesis.body import TUBES, bodies, profile_of
from tracking.synthesis.crowd import PlannedWalk, walk
from tracking.synthesis.figures import Figures
from tracking.synthesis.gait import Steps, steps_of
from tracking.synthesis.itineraries import plan_itineraries
from tracking.synthesis.passages import plan_passage
from tracking.synthesis.postures import Stoops, stoops_of
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenario import Moment, Scenario
from tracking.synthesis.skeleton import Posture, skeleton_of
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.wardrobe import ATLAS, PATCHES, RED_AND_BROWN, random_outfit, texture

LEVELS = 3
"""Each person's texture is kept in this many sizes, each half of the one before."""


_FIXED: Mapping[str, Callable[[], Scenario]] = MappingProxyType(
    {
        "marks": marks.standing,
        "marks-walking": marks.walking,
        "marks-pairs": marks.pairs,
    }
)
_VARIED: Mapping[str, Callable[[int], Scenario]] = MappingProxyType(
    {
        "situations": situations.situations,
        **{
            f"situation-{n}": partial(situations.situation, n)
            for n in range(1, situations.COUNT + 1)
        },
    }
)
"""Another seed is another way of doing the same."""


@dataclass(frozen=True, slots=True, eq=False)
class Cast:
    """The people of a recording; the index of a person is the id less one.

    Attributes:
        figures: bodies, a row per person.
        walks, steps, stoops: per person; None for who never sets off.
        textures: (k, 3) texels of all people and sizes, linear, blue, green, red.
        moments: what of a scenario is looked at.
    """

    figures: Figures
    walks: tuple[PlannedWalk | None, ...]
    steps: tuple[Steps | None, ...]
    stoops: tuple[Stoops | None, ...]
    textures: Float32s
    moments: tuple[Moment, ...] = ()

    @classmethod
    def of_scene(
        cls, spec: SceneSpec, rig: Rig, people: int, frames: int, fps: float, seed: int
    ) -> Cast:
        """Cast a scene; equal arguments give equal people."""
        walks, moments = _ways(spec, rig, people, frames, fps, seed)
        rng = np.random.default_rng((seed, 2))
        figures = Figures.at_random(people, rng)
        figures = figures.in_trousers() if spec.uniform == RED_AND_BROWN else figures
        starts = rng.uniform(0, 1, people)
        steps = tuple(
            None if way is None else steps_of(way, float(figures.height_m[i]), fps, starts[i])
            for i, way in enumerate(walks)
        )
        rng = np.random.default_rng((seed, 4))
        stoops = tuple(
            None if way is None else stoops_of(way, fps, spec.stoops, rng) for way in walks
        )
        textures = _textures(figures, spec, seed)
        return cls(figures, walks, steps, stoops, textures, moments)

    def on_floor(self, frame: int) -> NDArray[np.intp]:
        """Indices of who is there in a frame, in view or not."""
        there = [way is not None and frame in way.frames for way in self.walks]
        return np.flatnonzero(there)

    def places(self, people: NDArray[np.intp], frame: int) -> Floats:
        """World x, y (n, 2) of people who are there in a frame."""
        walks = [self._walk(person) for person in people]
        places = [way.position[frame - way.first_frame] for way in walks]
        return np.array(places).reshape(-1, 2)

    def posture(self, people: NDArray[np.intp], frame: int) -> Posture:
        """What people who are there do in a frame."""
        walks = [self._walk(person) for person in people]
        rows = [frame - way.first_frame for way in walks]
        steps = [self._steps(person) for person in people]
        stoops = [self._stoops(person) for person in people]
        moving = _at_rows(Steps, steps, rows) | _at_rows(Stoops, stoops, rows)
        return Posture(
            position=self.places(people, frame),
            heading=np.array([w.heading[row] for w, row in zip(walks, rows, strict=True)]),
            **moving,
        )

    def surfaces(self, people: NDArray[np.intp], posture: Posture) -> tuple[Floats, Floats]:
        """Vertices and normals (n, v, 3) of people in a posture."""
        figures = self.figures.of(people)
        return bodies(figures, skeleton_of(figures, posture))

    def _walk(self, person: int | np.intp) -> PlannedWalk:
        way = self.walks[person]
        assert way is not None  # only asked for people who are there
        return way

    def _steps(self, person: int | np.intp) -> Steps:
        steps = self.steps[person]
        assert steps is not None
        return steps

    def _stoops(self, person: int | np.intp) -> Stoops:
        stoops = self.stoops[person]
        assert stoops is not None
        return stoops


def _ways(
    spec: SceneSpec, rig: Rig, people: int, frames: int, fps: float, seed: int
) -> tuple[tuple[PlannedWalk | None, ...], tuple[Moment, ...]]:
    """Everybody's walk, as a scenario says or as people like."""
    if spec.scenario:
        scenario = scenario_of(spec, people, seed)
        return scenario.walks(frames, fps), scenario.moments
    rng = np.random.default_rng((seed, 1))
    if spec.passage is not None:
        plans = plan_passage(spec.passage, people, frames / fps, rng)
    else:
        plans = plan_itineraries(spec, rig, people, frames / fps, rng)
    return walk(spec, plans, frames, fps), ()


def _at_rows(
    kind: type[Steps | Stoops], ways: Sequence[Steps | Stoops], rows: list[int]
) -> dict[str, Floats]:
    """Each field of people's steps or stoops in one frame, a row per person."""
    return {
        name: np.array([getattr(way, name)[row] for way, row in zip(ways, rows, strict=True)])
        for name in kind.__dataclass_fields__
    }


def texture_coordinates() -> Float32s:
    """Column and row (v, 2) of each of a body's vertices in the person's texture."""
    coordinates = []
    for shape in TUBES:
        top, left, height, width = PATCHES[shape.patch]
        down = profile_of(shape.name)
        across = np.linspace(0.0, 1.0, shape.segments + 1)
        # Half a texel in from the edge: the neighbours in the texture are other clothes.
        column = left + 0.5 + across * (width - 1)
        row = top + 0.5 + down * (height - 1)
        grid = np.stack(np.meshgrid(column, row), axis=-1)
        coordinates.append(grid.reshape(-1, 2))
    return np.concatenate(coordinates).astype(np.float32)


def level_layout() -> tuple[NDArray[np.int32], NDArray[np.int32], int]:
    """First texel and row length of each size of a texture, and the texels per person."""
    rows, columns = ATLAS
    sizes = [(rows >> level) * (columns >> level) for level in range(LEVELS)]
    starts = np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.int32)
    strides = np.array([columns >> level for level in range(LEVELS)], np.int32)
    return starts, strides, sum(sizes)


def _textures(figures: Figures, spec: SceneSpec, seed: int) -> Float32s:
    texels = []
    for person in range(len(figures)):
        rng = np.random.default_rng((seed, 3, person))
        outfit = random_outfit(
            rng,
            long_hair=bool(figures.hair[person] > 0.55),
            coat=bool(figures.skirt[person] > 0 and figures.flare[person] < 0.8),
            skirt=bool(figures.skirt[person] > 0 and figures.flare[person] >= 0.8),
            uniform=spec.uniform,
            contrasting=spec.contrasting,
        )
        image = texture(outfit, rng)
        for _ in range(LEVELS):
            texels.append(image.reshape(-1, 3))
            half = image.shape[1] // 2, image.shape[0] // 2
            image = np.asarray(cv2.resize(image, half, interpolation=cv2.INTER_AREA), np.float32)
    return np.concatenate(texels) if texels else np.zeros((1, 3), np.float32)


def scenario_of(spec: SceneSpec, people: int, seed: int) -> Scenario:
    """The scenario that a scene follows.

    Raises:
        SettingsError: it is not for so many people.
    """
    fixed = _FIXED.get(spec.scenario)
    scenario = fixed() if fixed else _VARIED[spec.scenario](seed)
    if people != len(scenario.roles):
        raise SettingsError(
            "people is {people}; the scene {tracker} is for {count}, leave it out",
            people=people,
            tracker=spec.name,
            count=len(scenario.roles),
        )
    return scenario
