"""The people's bodies: height, build, what they carry; a row per person."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats


@dataclass(frozen=True, slots=True, eq=False)
class Figures:
    """What bodies look like apart from their colours. All arrays have n rows.

    Attributes:
        height_m: 1.5 to 1.95.
        girth: thickness of torso and limbs, about 1.
        shoulders, hips: width against the average build.
        skirt: length of a skirt or coat below the waist as a share of body height; 0: none.
        flare: how wide its hem is.
        hair: volume of the hair, 0..1; long from 0.6 on.
        pack: size of a backpack; 0: none.
        phone: the right arm holds a telephone, 0 or 1.
        trousers: width of trouser legs against tight ones.
        looseness: how far clothes stand off the torso, against tight ones.
    """

    height_m: Floats
    girth: Floats
    shoulders: Floats
    hips: Floats
    skirt: Floats
    flare: Floats
    hair: Floats
    pack: Floats
    phone: Floats
    trousers: Floats
    looseness: Floats

    @classmethod
    def at_random(cls, people: int, rng: np.random.Generator) -> Figures:
        """Bodies of different people, half of them of each build."""
        slender = rng.random(people) < 0.5
        mean_m = np.where(slender, 1.65, 1.77)
        height = np.clip(rng.normal(mean_m, 0.065), 1.5, 1.95)
        dressed = slender & (rng.random(people) < 0.28)
        coated = ~dressed & (rng.random(people) < 0.22)
        skirt = np.where(dressed, rng.uniform(0.17, 0.33, people), 0.0)
        skirt = np.where(coated, rng.uniform(0.14, 0.27, people), skirt)
        long_hair = slender & (rng.random(people) < 0.6)
        return cls(
            height_m=height,
            girth=np.clip(rng.normal(1.0, 0.075, people), 0.87, 1.22),
            shoulders=np.where(slender, 0.91, 1.0) * rng.uniform(0.96, 1.04, people),
            hips=np.where(slender, 1.04, 0.96) * rng.uniform(0.96, 1.05, people),
            skirt=skirt,
            flare=np.where(dressed, rng.uniform(0.9, 1.35, people), 0.72),
            hair=np.where(long_hair, rng.uniform(0.6, 1.0, people), rng.uniform(0, 0.5, people)),
            pack=np.where(rng.random(people) < 0.25, rng.uniform(0.85, 1.1, people), 0.0),
            phone=(rng.random(people) < 0.15).astype(float),
            trousers=rng.uniform(1.0, 1.22, people),
            looseness=rng.uniform(1.0, 1.12, people),
        )

    def in_trousers(self) -> Figures:
        """The same people in trousers, without coats or packs."""
        none = np.zeros(len(self))
        return replace(self, skirt=none, pack=none)

    def __len__(self) -> int:
        """The number of people."""
        return len(self.height_m)

    def of(self, people: NDArray[np.intp]) -> Figures:
        """The bodies of some of the people."""
        return Figures(
            **{name: getattr(self, name)[people] for name in Figures.__dataclass_fields__}
        )
