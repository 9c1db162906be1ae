"""What people wear: one texture a person, cut into patches for the parts of the body."""

from __future__ import annotations

from dataclasses import dataclass, replace

import cv2
import numpy as np

from tracking.arrays import Float32s
from tracking.synthesis.patterns import Colour, checks, folds, noise, plaid, plain, stripes

ATLAS = (320, 256)
"""Rows and columns of a person's texture."""

PATCHES = {
    # top, left, height, width in texels; columns run round the body from behind
    "torso": (0, 0, 128, 256),
    "leg": (128, 0, 128, 96),
    "arm": (128, 96, 128, 64),
    "head": (128, 160, 96, 96),
    "shoe": (224, 160, 32, 32),
    "pack": (224, 192, 32, 64),
    "skirt": (256, 0, 64, 256),
}
SIZES_M = {
    # length and girth that a patch covers on the body
    "torso": (0.76, 1.0),
    "leg": (0.88, 0.5),
    "arm": (0.72, 0.3),
    "skirt": (0.45, 1.1),
    "pack": (0.34, 0.8),
}

_SKINS = ((0.93, 0.74, 0.63), (0.87, 0.66, 0.53), (0.77, 0.56, 0.42), (0.55, 0.38, 0.28))
_HAIRS = (
    (0.09, 0.08, 0.07),
    (0.13, 0.10, 0.08),
    (0.25, 0.16, 0.10),
    (0.40, 0.27, 0.15),
    (0.66, 0.52, 0.32),
    (0.58, 0.57, 0.55),
)
_TOPS = (
    (0.16, 0.19, 0.30),
    (0.13, 0.13, 0.15),
    (0.62, 0.14, 0.15),
    (0.88, 0.87, 0.84),
    (0.24, 0.40, 0.60),
    (0.22, 0.38, 0.28),
    (0.80, 0.62, 0.20),
    (0.50, 0.50, 0.53),
    (0.52, 0.33, 0.47),
    (0.76, 0.60, 0.46),
    (0.85, 0.52, 0.46),
    (0.20, 0.48, 0.50),
    (0.43, 0.30, 0.21),
    (0.60, 0.68, 0.79),
)
_BOTTOMS = (
    (0.20, 0.25, 0.38),
    (0.29, 0.36, 0.50),
    (0.13, 0.13, 0.15),
    (0.32, 0.31, 0.30),
    (0.62, 0.55, 0.43),
    (0.36, 0.33, 0.24),
    (0.47, 0.49, 0.53),
    (0.17, 0.17, 0.22),
)
_SHOES = ((0.09, 0.08, 0.08), (0.28, 0.18, 0.12), (0.80, 0.79, 0.77), (0.45, 0.45, 0.48))
_CONTRAST = 0.35  # distance of two colours as displayed that nobody takes for one
RED_AND_BROWN = "red and brown"
_UNIFORMS = {
    # top and trousers
    "navy": ((0.20, 0.23, 0.33), (0.20, 0.23, 0.33)),
    RED_AND_BROWN: ((0.66, 0.13, 0.14), (0.36, 0.26, 0.18)),
}
_PATTERNS = ("plain", "plain", "stripes", "pinstripes", "checks", "plaid", "print", "jacket")


@dataclass(frozen=True, slots=True, eq=False)
class Outfit:
    """One person's colours (as displayed, 0..1) and choices.

    Attributes:
        skin, hair, top, second, bottom, shoes, pack: colours; `second` is in the top's pattern.
        pattern: of the top.
        sleeve: 0 short, 1 long. shorts: bare shins.
        jeans: the trousers are faded at the thighs.
        long_hair: the hair falls over the neck.
        cap: a cap of the second colour hides the hair.
        coat: what hangs below the waist is of the top's cloth, not of the bottom's.
        stockings: colour of the legs under a skirt; None: trousers.
    """

    skin: Colour
    hair: Colour
    top: Colour
    second: Colour
    bottom: Colour
    shoes: Colour
    pack: Colour
    pattern: str
    sleeve: float
    shorts: bool
    jeans: bool
    long_hair: bool
    cap: bool
    coat: bool
    stockings: Colour | None


def random_outfit(
    rng: np.random.Generator,
    *,
    long_hair: bool,
    coat: bool,
    skirt: bool,
    uniform: str,
    contrasting: bool = False,
) -> Outfit:
    """What one person wears; in a uniform only skin, hair and creases differ.

    With `contrasting`, top and trousers are of clearly different colours.
    """
    top, second = (_shade(_TOPS[i], rng) for i in rng.choice(len(_TOPS), 2, replace=False))
    bottom = _shade(_BOTTOMS[rng.integers(len(_BOTTOMS))], rng)
    pattern = str(rng.choice(_PATTERNS))
    skin = _shade(_SKINS[rng.choice(4, p=(0.35, 0.3, 0.2, 0.15))], rng)
    legs = skin * 0.95 if rng.random() < 0.55 else np.array((0.12, 0.11, 0.12))
    outfit = Outfit(
        skin=skin,
        hair=_shade(_HAIRS[rng.integers(len(_HAIRS))], rng),
        top=top,
        second=second,
        bottom=bottom,
        shoes=_shade(_SHOES[rng.integers(len(_SHOES))], rng),
        pack=_shade(_TOPS[rng.integers(len(_TOPS))], rng) * 0.8,
        pattern="jacket" if coat else pattern,
        sleeve=1.0 if coat or pattern == "jacket" else float(rng.random() < 0.6),
        shorts=bool(rng.random() < 0.08) and not (coat or skirt),
        jeans=bool(rng.random() < 0.4) and not skirt,
        long_hair=long_hair,
        cap=bool(rng.random() < 0.1) and not long_hair,
        coat=coat,
        stockings=legs if skirt else None,
    )
    if contrasting:
        outfit = _in_contrast(outfit, rng)
    return _in_uniform(outfit, uniform) if uniform else outfit


def _in_contrast(outfit: Outfit, rng: np.random.Generator) -> Outfit:
    """The outfit with other trousers, if its own are too near to the top's colour."""
    away = np.linalg.norm(np.array(_BOTTOMS) - outfit.top, axis=1)
    if np.linalg.norm(outfit.bottom - outfit.top) >= _CONTRAST:
        return outfit
    fitting = np.flatnonzero(away >= min(_CONTRAST, away.max()))
    return replace(outfit, bottom=_shade(_BOTTOMS[rng.choice(fitting)], rng))


def _in_uniform(outfit: Outfit, colours: str) -> Outfit:
    top, bottom = _UNIFORMS[colours]
    return replace(
        outfit,
        top=np.array(top),
        second=np.array(top) * 1.15,
        bottom=np.array(bottom),
        shoes=np.array(_SHOES[0]),
        pack=np.array(top) * 0.8,
        pattern="plain",
        sleeve=1.0,
        shorts=False,
        jeans=False,
        cap=False,
        stockings=None,
    )


def texture(outfit: Outfit, rng: np.random.Generator) -> Float32s:
    """The person's texture (rows, columns, 3), linear reflectance, blue, green, red."""
    atlas = np.full((*ATLAS, 3), 0.3, np.float32)
    painters = {
        "torso": _torso,
        "leg": _leg,
        "arm": _arm,
        "head": _head,
        "shoe": _shoe,
        "pack": _pack,
        "skirt": _skirt,
    }
    for name, paint in painters.items():
        top, left, height, width = PATCHES[name]
        area = np.clip(paint((height, width), outfit, rng), 0.0, 1.0)
        atlas[top : top + height, left : left + width] = area
    # Display values are gamma-coded; light adds up in linear ones.
    return np.ascontiguousarray(0.9 * (atlas[..., ::-1] ** 2))


def _shade(colour: tuple[float, float, float], rng: np.random.Generator) -> Colour:
    """A colour a little off, as no two dyes are alike."""
    return np.clip(np.array(colour) * rng.uniform(0.85, 1.12) * rng.uniform(0.95, 1.05, 3), 0, 1)


def _coordinates(name: str, shape: tuple[int, int]) -> tuple[Float32s, Float32s]:
    """Metres down and across a patch."""
    length, girth = SIZES_M[name]
    down = np.linspace(0, length, shape[0], dtype=np.float32)[:, None]
    across = np.linspace(0, girth, shape[1], endpoint=False, dtype=np.float32)[None]
    return np.broadcast_to(down, shape), np.broadcast_to(across, shape)


def _cloth(name: str, shape: tuple[int, int], outfit: Outfit) -> Float32s:
    """The top's cloth without folds."""
    down, across = _coordinates(name, shape)
    if outfit.pattern == "stripes":
        return stripes(down, 0.085, 0.45, outfit.top, outfit.second)
    if outfit.pattern == "pinstripes":
        return stripes(across, 0.0625, 0.3, outfit.top, 0.5 * outfit.top + 0.45)
    if outfit.pattern == "checks":
        return checks(across, down, 0.05, outfit.top, outfit.top * 0.6 + 0.25)
    if outfit.pattern == "plaid":
        return plaid(across, down, 0.125, outfit.top, outfit.second)
    return plain(shape, outfit.top)


def _torso(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    cloth = _cloth("torso", shape, outfit)
    rows = np.linspace(0, 1, shape[0])[:, None]
    front = np.abs(np.linspace(-0.5, 0.5, shape[1], endpoint=False))[None]
    if outfit.pattern == "print":
        chest = (front < 0.085) & (rows > 0.3) & (rows < 0.47)
        cloth[chest] = outfit.second
    if outfit.pattern == "jacket":
        opening = front < 0.012 + 0.07 * np.clip(0.62 - rows, 0, 1)
        cloth[np.broadcast_to(opening, shape)] = outfit.second
        lapel = (front > 0.012 + 0.07 * np.clip(0.62 - rows, 0, 1)) & (
            front < 0.030 + 0.09 * np.clip(0.62 - rows, 0, 1)
        )
        cloth[lapel] *= 0.72
    cloth *= folds(shape, 0.09, rng)[..., None]
    neckline = rows < 0.085 + 0.06 * np.clip(1 - front / 0.09, 0, 1)
    cloth[neckline] = outfit.skin * 0.93
    hem = 0.74 if outfit.pattern in ("jacket", "plain", "print") else 0.69
    hem = 1.1 if outfit.coat else hem
    below = np.broadcast_to(rows > hem, shape)
    cloth[below] = (outfit.bottom * folds(shape, 0.06, rng)[..., None])[below]
    cloth[np.broadcast_to(np.abs(rows - hem) < 0.008, shape)] *= 0.62
    return cloth


def _leg(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    if outfit.stockings is not None:
        return plain(shape, outfit.stockings)
    cloth = plain(shape, outfit.bottom)
    rows = np.linspace(0, 1, shape[0], dtype=np.float32)[:, None]
    if outfit.jeans:
        around = np.cos(np.linspace(-np.pi, np.pi, shape[1], dtype=np.float32))[None]
        faded = np.exp(-(((rows - 0.3) / 0.2) ** 2)) * np.clip(around, 0, 1)
        cloth = cloth + 0.13 * faded[..., None]
    cloth *= folds(shape, 0.08, rng)[..., None]
    # Cloth bunches behind the knee and over the shoe.
    bunched = np.exp(-(((rows - 0.56) / 0.06) ** 2)) + np.exp(-(((rows - 0.95) / 0.05) ** 2))
    creases = noise(shape, (3.0, shape[1] / 3), rng)
    cloth *= (1.0 + 0.09 * bunched * creases)[..., None]
    if outfit.shorts:
        bare = np.broadcast_to(rows > 0.55, shape)
        cloth[bare] = outfit.skin * 0.95
    return cloth.astype(np.float32)


def _arm(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    cloth = _cloth("arm", shape, outfit) * folds(shape, 0.10, rng)[..., None]
    rows = np.linspace(0, 1, shape[0])[:, None]
    end = 0.745 if outfit.sleeve > 0.5 else 0.34
    cloth[np.broadcast_to(np.abs(rows - end) < 0.012, shape)] *= 0.7
    cloth[np.broadcast_to(rows > end, shape)] = outfit.skin
    return cloth


def _head(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    """Hair over skin, with brows, eyes, mouth and ears; the face is in the middle columns."""
    height, width = shape
    rows = np.linspace(0, 1, height)[:, None]
    around = np.abs(np.linspace(-1, 1, width, endpoint=False))[None]  # 0 face, 1 back of the head
    skin = plain(shape, outfit.skin) * (1.0 + 0.02 * noise(shape, (6, 6), rng)[..., None])
    for row, at, tall, wide, shade in (
        (0.50, 0.17, 0.022, 0.075, 0.45),  # brows
        (0.555, 0.16, 0.028, 0.05, 0.35),  # eyes
        (0.79, 0.0, 0.018, 0.09, 0.68),  # mouth
        (0.60, 0.52, 0.075, 0.03, 0.80),  # ears
    ):
        spot = np.exp(-(((rows - row) / tall) ** 2) - ((around - at) / wide) ** 2)
        skin *= (1.0 - (1.0 - shade) * spot)[..., None]
    fringe = 0.40 + 0.04 * noise(shape, (height, 7.0), rng)
    sides = np.where(around > 0.42, 0.58, fringe)
    low = np.where(around > 0.58, 1.1 if outfit.long_hair else 0.80, sides)
    if outfit.long_hair:
        low = np.where((around > 0.36) & (around <= 0.58), 1.1, low)
    strands = 1.0 + 0.10 * noise(shape, (height / 3, 2.5), rng) + 0.06 * noise(shape, (5, 5), rng)
    hair = plain(shape, outfit.hair) * strands[..., None]
    covered = np.broadcast_to(rows < low, shape)
    skin[covered] = hair[covered]
    if outfit.cap:
        skin[np.broadcast_to(rows < np.where(around < 0.3, 0.46, 0.40), shape)] = outfit.second
    edge = cv2.GaussianBlur(covered.astype(np.float32), (0, 0), 1.5)
    return np.asarray(skin * (1.0 - 0.25 * (edge * (1 - covered)))[..., None], np.float32)


def _shoe(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    leather = plain(shape, outfit.shoes) * folds(shape, 0.08, rng)[..., None]
    around = np.abs(np.linspace(-1, 1, shape[1], endpoint=False))[None]
    leather[np.broadcast_to(around > 0.72, shape)] = 0.25 + 0.4 * outfit.shoes
    return leather


def _pack(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    canvas = plain(shape, outfit.pack) * folds(shape, 0.08, rng)[..., None]
    canvas[19:21] *= 0.6
    canvas[10:12] *= 0.75
    return canvas


def _skirt(shape: tuple[int, int], outfit: Outfit, rng: np.random.Generator) -> Float32s:
    cloth = _cloth("skirt", shape, outfit) if outfit.coat else plain(shape, outfit.bottom)
    return np.asarray(cloth * folds(shape, 0.12, rng)[..., None], np.float32)
