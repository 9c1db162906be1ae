"""The rendered clips on which body parts are measured; each is made once and kept."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path

from platformdirs import user_cache_path

from tracking.synthesis import SCENES, render_recording
from tracking.synthesis.cast import Cast
from tracking.synthesis.rig import Rig

FPS = 20.0


@dataclass(frozen=True, slots=True)
class Clip:
    """One rendered scene.

    Attributes:
        scene: its name in `SCENES`.
        seed: says who comes by and how.
    """

    scene: str
    seed: int

    def cast(self) -> Cast:
        """The people of the clip, as they were rendered."""
        spec = SCENES[self.scene]
        rig = Rig.of_scene(spec, spec.size_px)
        return Cast.of_scene(spec, rig, spec.people, round(spec.seconds * FPS), FPS, self.seed)


REPORTED = tuple(Clip("walkway", seed) for seed in range(4201, 4221))
"""20 clips, 100 people, on which nothing was trained or chosen."""

REPORTED_CROUCHING = tuple(Clip("crouching", seed) for seed in range(4251, 4257))

TRAINED = tuple(Clip("walkway", seed) for seed in range(4111, 4131))
"""The built-in detector learns from these."""

TRAINED_CROUCHING = tuple(Clip("crouching", seed) for seed in range(4161, 4167))

TUNED = tuple(Clip("walkway", seed) for seed in range(4101, 4105))
"""For choosing settings: neither learnt from nor reported on."""

TUNED_CROUCHING = tuple(Clip("crouching", seed) for seed in range(4151, 4153))


def folder_of(clip: Clip, kept: Path | None = None) -> Path:
    """The clip's recording of the left eye, rendered if it is not there yet.

    Args:
        clip: which.
        kept: where clips are kept; a folder of the user's cache if None.
    """
    above = kept or user_cache_path("trackwright", appauthor=False) / "parts"
    folder = above / f"{clip.scene}-{clip.seed}"
    if not (folder / "truth_parts.csv").is_file():
        print(f"rendering {folder}", file=sys.stderr)
        render_recording(folder, clip.scene, seed=clip.seed, fps=FPS, eyes=1)
    return folder
