"""A street under the sky, small in the picture, whose sun goes behind clouds and stays there."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.recording import StereoFrame
from tracking.synthesis import SCENES, Scene, SceneSpec
from tracking.synthesis.truth import SceneTruth

FPS = 10.0
SIZE = 320, 240
_FADE_S = 3.0
_FROM_SUN = 0.1
"""Share of the sun's light that comes through the clouds."""
_CLOUDS = 6
_CLOUDS_PX_S = 7.0
_DIMMED = 0.45
"""Of the sky's light that goes with the sun."""


@dataclass(frozen=True)
class Street:
    """The street, rendered in both lights.

    Attributes:
        sunny, cloudy: the same people in the same places. change_s: when the sun goes.
        sky: (height, 8 x width) grey levels of clouds that drift. above: (height, width) where
            the picture shows them; the camera is higher than people, whose heads are below.
    """

    sunny: Scene
    cloudy: Scene
    change_s: float
    sky: NDArray[np.float32]
    above: NDArray[np.bool_]

    @property
    def frames(self) -> int:
        return self.sunny.frames

    def read(self, number: int) -> tuple[StereoFrame, SceneTruth]:
        """A frame as one camera records it, and who is in it."""
        second = number / FPS
        share = float(np.clip((second - self.change_s) / _FADE_S, 0.0, 1.0))
        scenes = ((self.sunny, 1.0 - share), (self.cloudy, share))
        shown = [(*scene.frame(number), weight) for scene, weight in scenes if weight]
        picture = np.sum([weight * frame.left for frame, _, weight in shown], axis=0)
        clouds = np.roll(self.sky, round(_CLOUDS_PX_S * second), axis=1)[:, : SIZE[0]]
        picture[self.above] = clouds[self.above, None] * (1.0 - _DIMMED * share)
        left = np.clip(np.rint(picture), 0, 255).astype(np.uint8)
        return StereoFrame(number, second, left, None), shown[0][1]

    def samples(self) -> tuple[list[StereoFrame], list[StereoFrame]]:
        """What the background is learnt from: frames spread over all, and moments later."""
        moment = round(0.4 * FPS)
        numbers = np.linspace(0, self.frames - 1 - moment, 15).astype(int).tolist()
        return [self.read(n)[0] for n in numbers], [self.read(n + moment)[0] for n in numbers]


def street(seconds: float, change_s: float, seed: int = 5, people: int = 7) -> Street:
    """The street for so long, sunny until `change_s`."""
    sunny = _spec()
    lamp = sunny.lamp
    direct = tuple(_FROM_SUN * value for value in lamp.direct)
    cloudy = replace(sunny, lamp=replace(lamp, direct=direct))
    scenes = [
        Scene(spec, people, seed, seconds=seconds, size=SIZE, fps=FPS, cameras=1)
        for spec in (sunny, cloudy)
    ]
    random = np.random.default_rng(seed)
    coarse = random.uniform(120.0, 245.0, (_CLOUDS, 4 * _CLOUDS)).astype(np.float32)
    sky = cv2.resize(coarse, (4 * SIZE[0], SIZE[1]), interpolation=cv2.INTER_CUBIC)
    sky = np.concatenate((sky, sky[:, ::-1]), axis=1)  # no seam where it begins again
    rays = scenes[0].rig.rays(np.stack(np.meshgrid(*map(np.arange, SIZE)), axis=-1))
    return Street(*scenes, change_s, np.asarray(sky, np.float32), rays[..., 2] >= -0.01)


def _spec() -> SceneSpec:
    return replace(
        SCENES["outdoor"],
        height_m=3.0,
        tilt_deg=8.0,
        area_m=(-3.0, 5.0, 3.0, 9.0),
        entrances=("left", "right"),
        pauses=0.2,
    )
