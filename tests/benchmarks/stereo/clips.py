"""The rendered clips on which stereo trackers are measured."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from tests.benchmarks.kept_results import rendering
from tests.benchmarks.rendered_clips import Clip, folder_of
from tracking.synthesis import SCENES, Disturbances

PAPERS = ("indoor", "outdoor", "lobby", "plaza", "square", "uniforms")
"""The camera set-ups of both papers, and people in clothes of one colour."""

SCENES_MEASURED = (*PAPERS, "pillars", "corridor", "ceiling")
_LEAST_PEOPLE = 30
_FEWER_WILL_DO = ("corridor", "ceiling")  # no paper and no goal of accuracy has them
_ROBUSTNESS = ("lobby", "plaza")
_DIMMED_S, _SHORT_S = 7.0, 15.0


KEPT = Path(tempfile.gettempdir()) / "trackwright-stereo"
"""Where clips and runs are kept unless told otherwise."""


@dataclass(frozen=True, slots=True)
class Clips:
    """All that one report or one round of tuning looks at.

    Attributes:
        of_scene: clips by scene, each as long and as full as the scene is.
        dimmed: a part of the light goes out in them.
    """

    of_scene: Mapping[str, tuple[Clip, ...]]
    dimmed: tuple[Clip, ...]

    @property
    def sound(self) -> tuple[Clip, ...]:
        """Clips whose right camera is troubled afterwards."""
        return tuple(self.of_scene[scene][0] for scene in _ROBUSTNESS)

    def folders(self, kept: Path | None = None) -> dict[str, Path]:
        """The recordings of all scenes by their clips' names."""
        clips = [clip for several in self.of_scene.values() for clip in several]
        return {clip.name: folder(clip, kept) for clip in clips}


def _clips(first_seed: int, numbers: Mapping[str, int]) -> Clips:
    disturbances = Disturbances(dimmed_s=_DIMMED_S)
    return Clips(
        of_scene={
            scene: tuple(Clip(scene, first_seed + k) for k in range(number))
            for scene, number in numbers.items()
        },
        dimmed=tuple(
            Clip(scene, first_seed, _SHORT_S, SCENES[scene].people // 2, None, disturbances)
            for scene in _ROBUSTNESS
        ),
    )


def _clips_needed(scene: str) -> int:
    """So many that enough people are detected, though one of each clip may come too late for it."""
    return 1 if scene in _FEWER_WILL_DO else -(-_LEAST_PEOPLE // (SCENES[scene].people - 1))


_NEEDED = {scene: _clips_needed(scene) for scene in SCENES_MEASURED}

REPORTED = _clips(6101, _NEEDED)
"""No setting is chosen on these, but each change is measured on them: fresh ones tell more."""

FIRST_FRESH = 6306
FRESH_ROUNDS = 2
"""The second half of each scene's fresh clips was added once the figures of the first were known,
as they were too few, with nothing of the trackers changed: both rounds are told. 1: all at once."""

FRESH = _clips(FIRST_FRESH, {scene: 4 * number for scene, number in _NEEDED.items()})
"""Four times as many: of some eighty people the share kept differs by three in a hundred and more
with other seeds.

Nobody has looked at these, so goals are judged on them. Whoever changes a tracker, or anything
it sees with, after they were measured, moves the first seed on, beyond all that were ever used:
what was seen once is no longer fresh."""

TUNED = _clips(6001, dict.fromkeys(SCENES_MEASURED, 1))
"""For choosing settings; never reported."""


def folder(clip: Clip, kept: Path | None = None) -> Path:
    """The clip's recording, rendered if it is not there yet.

    Clips in the temporary folder stand apart by what they were rendered with; those in a folder
    that is named are taken as they are.
    """
    return folder_of(clip, kept or KEPT / rendering())
