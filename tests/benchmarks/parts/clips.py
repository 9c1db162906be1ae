"""The rendered clips on which body parts are measured; each is made once and kept."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from platformdirs import user_cache_path

from tests.benchmarks.kept_results import rendering as rendered_with
from tests.benchmarks.parts import scenes
from tests.benchmarks.parts.scenes import ELSEWHERE
from tracking.synthesis import SCENES, SceneSpec, render_recording
from tracking.synthesis.cast import Cast
from tracking.synthesis.rig import Rig

FPS = 20.0


@dataclass(frozen=True, slots=True)
class Clip:
    """One rendered scene.

    Attributes:
        scene: its name in `SCENES` or `ELSEWHERE`.
        seed: says who comes by and how.
    """

    scene: str
    seed: int

    @property
    def spec(self) -> SceneSpec:
        """The scene's definition."""
        return SCENES[self.scene] if self.scene in SCENES else ELSEWHERE[self.scene]

    def cast(self) -> Cast:
        """The people of the clip, as they were rendered."""
        spec = self.spec
        rig = Rig.of_scene(spec, spec.size_px)
        return Cast.of_scene(spec, rig, spec.people, round(spec.seconds * FPS), FPS, self.seed)


def _clips(scene: str, seeds: Iterable[int]) -> tuple[Clip, ...]:
    return tuple(Clip(scene, seed) for seed in seeds)


REPORTED = _clips("walkway", range(4301, 4321))
"""20 clips, 100 people, on which nothing was trained or chosen."""

REPORTED_CROUCHING = _clips("crouching", range(4351, 4357))

REPORTED_ELSEWHERE = tuple(clip for scene in ELSEWHERE for clip in _clips(scene, (4391,)))
"""People as other cameras see them: for the detector alone."""

TRAINED = (
    *_clips("walkway", range(4111, 4129)),
    *_clips("crouching", range(4161, 4166)),
    *(clip for scene in ELSEWHERE for clip in _clips(scene, (4142, 4143))),
)
"""The built-in detector learns from these."""

CHECKED = (
    *_clips("walkway", range(4171, 4175)),
    *_clips("crouching", (4181,)),
    *(clip for scene in ELSEWHERE for clip in _clips(scene, (4191,))),
)
"""What the detector learns from, and how, was chosen by these."""

TUNED = _clips("walkway", range(4101, 4105))
"""For choosing settings of trackers: neither learnt from nor reported on."""

TUNED_CROUCHING = _clips("crouching", range(4151, 4153))


def folder_of(clip: Clip, kept: Path | None = None) -> Path:
    """The clip's recording of the left camera, rendered if it is not there yet.

    Clips stand apart by what they were rendered with: none is left over from another rendering.

    Args:
        clip: which.
        kept: where clips are kept; a folder of the user's cache if None.
    """
    above = kept or user_cache_path("trackwright", appauthor=False) / "parts"
    folder = above / rendering() / f"{clip.scene}-{clip.seed}"
    if not (folder / "truth_parts.csv").is_file():
        print(f"rendering {folder}", file=sys.stderr)
        render_recording(folder, clip.spec, seed=clip.seed, fps=FPS, cameras=1)
    return folder


def rendering() -> str:
    """A short hash over whatever clips are rendered with, scenes and the frame rate among it."""
    return rendered_with(str(FPS), Path(scenes.__file__).read_text(encoding="utf-8"))
