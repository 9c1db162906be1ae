"""How often a colour histogram mistakes something else for a body part, equalised and not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.clips import Clip
from tracking.people.parts import (
    bhattacharyya,
    candidate_histograms,
    decompose,
    equalisation,
    equalised,
    even_division,
    inner_rectangles,
    level_histograms,
    ycbcr,
)
from tracking.synthesis import SCENES, Scene
from tracking.tracks import PART_WORDS, PARTS

Floats = NDArray[np.float64]

IMAGES, REGIONS = 50, 1000
"""[ZhaoLee2009] section 5.1: as many images, and as many random regions in each."""

PAPER = {"head": (0.13, 1.95), "torso": (0.16, 1.47), "hip_leg": (0.09, 1.45)}
"""[ZhaoLee2009] section 5.1: false alarms in %, with equalisation and without."""

_NEAR = 400
_WHOLE = 0.99


@dataclass(frozen=True, slots=True)
class Target:
    """A person's parts in an image.

    Attributes:
        picture: (height, width, 3) of `ycbcr`.
        rectangles: (3, 4) inner rectangles of head, torso and hip-leg.
    """

    picture: NDArray[np.uint8]
    rectangles: Floats


def measure(clips: Sequence[Clip], images: int = IMAGES, seed: int = 0) -> dict[str, Any]:
    """False alarms by part, in % of all regions tried, beside the paper's.

    Returns:
        "images", "regions" (tried for each part) and "parts": by part "with", "without",
        "paper_with" and "paper_without" in %, "threshold_with" and "threshold_without".
    """
    found = list(targets(clips, images))
    alarms = {name: false_alarms(found, name, seed) for name in ("with", "without")}
    parts: dict[str, dict[str, float]] = {}
    for k, part in enumerate(PART_WORDS):
        parts[part] = {"paper_with": PAPER[part][0], "paper_without": PAPER[part][1]}
        for name, (counts, thresholds) in alarms.items():
            parts[part][name] = round(100 * float(counts[k]) / (len(found) * REGIONS), 3)
            parts[part][f"threshold_{name}"] = round(float(thresholds[k]), 3)
    return {"images": len(found), "regions": len(found) * REGIONS, "parts": parts}


def targets(clips: Sequence[Clip], images: int) -> Iterator[Target]:
    """Whole people in frames spread over the clips, as many as there are images."""
    shares = np.array_split(np.arange(images), len(clips))
    for clip, share in zip(clips, shares, strict=True):
        scene = Scene(SCENES[clip.scene], seed=clip.seed, cameras=1)
        for target in np.linspace(0, scene.frames - 1, len(share) + 2)[1:-1].astype(int):
            yield _target(scene, int(target))


def _target(scene: Scene, start: int) -> Target:
    """The person seen best in the first frame from `start` on that shows somebody whole."""
    for number in (*range(start, scene.frames), *range(start)):
        frame, truth = scene.frame(number)
        height, width = frame.left.shape[:2]
        far = truth.box[:, :2] + truth.box[:, 2:]
        whole = (truth.visibility > _WHOLE) & (truth.box[:, :2] > 0).all(axis=1)
        whole &= (far < (width - 1, height - 1)).all(axis=1)
        if whole.any():
            track = int(truth.track[int(np.flatnonzero(whole)[0])])
            mask = scene.surfaces(number).track == track
            v, u = np.nonzero(mask)
            low, high = np.array((u.min(), v.min())) - 0.5, np.array((u.max(), v.max())) + 0.5
            box = np.concatenate((low, high - low))
            picture = ycbcr(frame.left)
            return Target(picture, inner_rectangles(mask, box, decompose(mask, picture, box)))
    raise ValueError(f"nobody is seen whole in {scene.spec.name}")


def false_alarms(found: Sequence[Target], kind: str, seed: int) -> tuple[Floats, Floats]:
    """How many random regions away from a part look at least as much like it as near ones.

    [ZhaoLee2009] section 5.1: the threshold is the mean similarity of the regions that share more
    than half of their area with the part.

    Args:
        found: the images.
        kind: "with" or "without" equalisation: bins of equal width.
        seed: of the regions; both kinds are tried on the same ones.

    Returns:
        (3,) counts by part, and (3,) mean thresholds.
    """
    rng = np.random.default_rng(seed)
    counts, thresholds = np.zeros(PARTS), np.zeros(PARTS)
    for target in found:
        near = np.stack([_near(rectangle, rng) for rectangle in target.rectangles])
        away = np.stack([_away(rectangle, target.picture, rng) for rectangle in target.rectangles])
        similar = _similar(target, np.concatenate((near, away), axis=1), kind)
        threshold = similar[:, : near.shape[1]].mean(axis=1)
        counts += (similar[:, near.shape[1] :] >= threshold[:, None]).sum(axis=1)
        thresholds += threshold / len(found)
    return counts, thresholds


def _similar(target: Target, rectangles: Floats, kind: str) -> Floats:
    """(3, n) similarity of rectangles (3, n, 4) to the parts."""
    models = level_histograms(target.picture, target.rectangles)
    mapping = equalisation(models) if kind == "with" else even_division(len(models))
    owner = np.repeat(np.arange(len(models)), rectangles.shape[1])
    seen = candidate_histograms(target.picture, rectangles.reshape(-1, 4), owner, mapping)
    alike = bhattacharyya(seen, equalised(models, mapping)[owner])
    return alike.reshape(len(models), -1).astype(np.float64)


def _near(rectangle: Floats, rng: np.random.Generator) -> Floats:
    """(n, 4) the rectangle shifted so that more than half of its area stays."""
    shift = rng.uniform(-0.5, 0.5, (4 * _NEAR, 2))
    stays = (1 - np.abs(shift)).prod(axis=1) > 0.5
    near = np.tile(rectangle, (_NEAR, 1))
    near[:, :2] += shift[stays][:_NEAR] * rectangle[2:]
    return near


def _away(rectangle: Floats, picture: NDArray[np.uint8], rng: np.random.Generator) -> Floats:
    """(REGIONS, 4) rectangles of the same size anywhere in the picture but off the part."""
    room = np.array(picture.shape[1::-1]) - rectangle[2:]
    middle = rng.uniform(0, 1, (4 * REGIONS, 2)) * room + rectangle[2:] / 2
    off = (np.abs(middle - rectangle[:2]) > rectangle[2:]).any(axis=1)
    return np.column_stack((middle[off][:REGIONS], np.tile(rectangle[2:], (REGIONS, 1))))
