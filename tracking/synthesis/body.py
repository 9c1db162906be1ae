"""Bodies: from a skeleton to the surface of a clothed person.

Profiles are shares of body height, from the top of each tube to its end; they were drawn by eye
after photographs of walking people.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.synthesis.figures import Figures
from tracking.synthesis.skeleton import UP, Skeleton, left_of
from tracking.synthesis.tubes import Rings, TubeShape, directions, surface
from tracking.tracks import HEAD, HIP_LEG, TORSO

_WAIST = 0.585
_TORSO = np.array(
    # height, half width, half depth, forward
    [
        [0.886, 0.0005, 0.0005, 0.010],
        [0.885, 0.034, 0.038, 0.010],
        [0.858, 0.036, 0.040, 0.003],
        [0.844, 0.060, 0.047, -0.002],
        [0.830, 0.090, 0.055, -0.002],
        [0.810, 0.108, 0.063, 0.000],
        [0.775, 0.111, 0.070, 0.003],
        [0.730, 0.106, 0.073, 0.004],
        [0.680, 0.097, 0.068, 0.003],
        [0.630, 0.091, 0.064, 0.003],
        [_WAIST, 0.092, 0.064, 0.002],
        [0.540, 0.097, 0.067, -0.003],
        [0.505, 0.095, 0.065, -0.005],
        [0.478, 0.074, 0.050, -0.003],
        [0.455, 0.0005, 0.0005, 0.000],
    ]
)
_HEAD = np.array(
    # share of the head's height, half width, half depth, forward
    [
        [1.000, 0.0005, 0.0005, -0.006],
        [0.985, 0.0160, 0.0190, -0.006],
        [0.940, 0.0290, 0.0370, -0.005],
        [0.860, 0.0390, 0.0500, -0.003],
        [0.740, 0.0445, 0.0560, -0.001],
        [0.600, 0.0450, 0.0555, 0.000],
        [0.470, 0.0435, 0.0530, 0.001],
        [0.350, 0.0415, 0.0485, 0.004],
        [0.220, 0.0370, 0.0415, 0.009],
        [0.090, 0.0290, 0.0310, 0.014],
        [0.010, 0.0200, 0.0200, 0.016],
        [-0.02, 0.0010, 0.0010, 0.014],
    ]
)
_CHIN, _CROWN = 0.872, 1.0
_NECK = 0.845
_NOSE_RING, _NOSE_M = 7, 0.0085
_ARM = np.array(
    # 0 shoulder .. 1 elbow .. 2 wrist .. fingertips, half width, half depth
    [
        [-0.13, 0.0005, 0.0005],
        [-0.09, 0.021, 0.024],
        [0.03, 0.031, 0.034],
        [0.25, 0.031, 0.034],
        [0.60, 0.028, 0.030],
        [0.92, 0.026, 0.027],
        [1.12, 0.026, 0.026],
        [1.45, 0.024, 0.024],
        [1.88, 0.020, 0.020],
        [1.96, 0.015, 0.017],
        [2.22, 0.012, 0.022],
        [2.46, 0.011, 0.019],
        [2.55, 0.007, 0.011],
        [2.57, 0.0005, 0.0005],
    ]
)
_LEG = np.array(
    # 0 hip .. 1 knee .. 2 ankle, half width, half depth
    [
        [-0.16, 0.042, 0.052],
        [0.03, 0.051, 0.063],
        [0.22, 0.050, 0.057],
        [0.48, 0.044, 0.049],
        [0.78, 0.038, 0.041],
        [0.95, 0.036, 0.038],
        [1.12, 0.034, 0.037],
        [1.38, 0.033, 0.037],
        [1.65, 0.029, 0.031],
        [1.86, 0.027, 0.028],
        [1.95, 0.027, 0.029],
        [1.97, 0.018, 0.020],
    ]
)
_FOOT = np.array(
    # ahead of the ankle, half width, half height
    [
        [-0.040, 0.0005, 0.0005],
        [-0.034, 0.019, 0.018],
        [-0.006, 0.023, 0.026],
        [0.030, 0.024, 0.023],
        [0.068, 0.028, 0.016],
        [0.096, 0.024, 0.012],
        [0.112, 0.0005, 0.0005],
    ]
)
_ANKLE_OVER_SOLE = 0.042
_SKIRT_RINGS, _PACK_RINGS = 7, 7
_PACK = np.array(
    # height, half width, half depth
    [
        [0.800, 0.0005, 0.0005],
        [0.798, 0.062, 0.030],
        [0.775, 0.074, 0.042],
        [0.700, 0.080, 0.052],
        [0.635, 0.080, 0.054],
        [0.612, 0.070, 0.044],
        [0.608, 0.0005, 0.0005],
    ]
)


def _bands(rings: int, part: int) -> tuple[int, ...]:
    return (part,) * (rings - 1)


_TORSO_PARTS = tuple(TORSO if height > _WAIST else HIP_LEG for height in _TORSO[:-1, 0])
TUBES = (
    TubeShape("torso", len(_TORSO), 16, 2.3, "torso", _TORSO_PARTS),
    TubeShape("head", len(_HEAD), 14, 2.0, "head", _bands(len(_HEAD), HEAD)),
    TubeShape("left arm", len(_ARM), 8, 2.0, "arm", _bands(len(_ARM), TORSO)),
    TubeShape("right arm", len(_ARM), 8, 2.0, "arm", _bands(len(_ARM), TORSO)),
    TubeShape("left leg", len(_LEG), 10, 2.0, "leg", _bands(len(_LEG), HIP_LEG)),
    TubeShape("right leg", len(_LEG), 10, 2.0, "leg", _bands(len(_LEG), HIP_LEG)),
    TubeShape("left shoe", len(_FOOT), 8, 2.6, "shoe", _bands(len(_FOOT), HIP_LEG)),
    TubeShape("right shoe", len(_FOOT), 8, 2.6, "shoe", _bands(len(_FOOT), HIP_LEG)),
    TubeShape("skirt", _SKIRT_RINGS, 16, 2.2, "skirt", _bands(_SKIRT_RINGS, HIP_LEG)),
    TubeShape("pack", _PACK_RINGS, 10, 3.4, "pack", _bands(_PACK_RINGS, TORSO)),
)


def topology() -> tuple[NDArray[np.int32], NDArray[np.int8]]:
    """Triangles (t, 3) of one person's vertices, and the body part (t,) of each."""
    triangles, first = [], 0
    for shape in TUBES:
        triangles.append(shape.triangles() + np.int32(first))
        first += shape.vertices
    return np.concatenate(triangles), np.concatenate([s.triangle_parts() for s in TUBES])


def bodies(figures: Figures, skeleton: Skeleton) -> tuple[Floats, Floats]:
    """Vertices in world metres and outward unit normals, (n, v, 3) each, tube after tube."""
    rings = [_torso(figures, skeleton), _head(figures, skeleton)]
    rings += [_arm(figures, skeleton, hand) for hand in (0, 1)]
    rings += [_leg(figures, skeleton, leg) for leg in (0, 1)]
    rings += [_shoe(figures, skeleton, leg) for leg in (0, 1)]
    rings += [_skirt(figures, skeleton), _pack(figures, skeleton)]
    surfaces = [surface(shape, ring) for shape, ring in zip(TUBES, rings, strict=True)]
    vertices = np.concatenate([vertex for vertex, _ in surfaces], axis=1)
    _add_noses(vertices, figures, skeleton)
    return vertices, np.concatenate([normal for _, normal in surfaces], axis=1)


def _upright(figures: Figures, skeleton: Skeleton, heights: Floats) -> tuple[Floats, Floats]:
    """Points (n, r, 3) on the spine at heights (r,), and the forward directions there."""
    size = figures.height_m[:, None]
    rise = heights[None] * size - skeleton.pelvis[:, 2:]
    rise = rise + (skeleton.pelvis[:, 2:] - 0.517 * size)
    over = np.maximum(rise - (_NECK - 0.517) * size, 0.0)
    centre = skeleton.pelvis[:, None] + skeleton.spine[:, None] * (rise - over)[..., None]
    centre = centre + skeleton.neck[:, None] * over[..., None]
    centre = centre + skeleton.lean[:, None] * rise[..., None]
    twist = np.clip((heights - _WAIST) / (0.73 - _WAIST), 0.0, 1.0)[None, :, None]
    forward = skeleton.forward[:, None] * (1 - twist) + skeleton.chest_forward[:, None] * twist
    return centre, forward


def _torso(figures: Figures, skeleton: Skeleton) -> Rings:
    centre, forward = _upright(figures, skeleton, _TORSO[:, 0])
    size = figures.height_m[:, None]
    upper = np.clip((_TORSO[:, 0] - 0.55) / 0.2, 0.0, 1.0)[None]
    build = figures.shoulders[:, None] * upper + figures.hips[:, None] * (1 - upper)
    clothed = (_TORSO[:, 0] < 0.85)[None]
    loose = np.where(clothed, figures.looseness[:, None] * figures.girth[:, None], 1.0)
    centre = centre + forward * (_TORSO[:, 3] * size)[..., None]
    return Rings(
        centre,
        directions(centre),
        left_of(forward),
        _TORSO[:, 1] * size * np.where(clothed, build, 1.0) * np.sqrt(loose),
        _TORSO[:, 2] * size * loose,
    )


def _head(figures: Figures, skeleton: Skeleton) -> Rings:
    size = figures.height_m[:, None]
    heights = _CHIN + _HEAD[:, 0] * (_CROWN - _CHIN)
    centre, _ = _upright(figures, skeleton, heights)
    hair = figures.hair[:, None]
    thick = 1.0 + 0.07 * hair * (_HEAD[:, 0] > 0.55)
    long = np.clip((hair - 0.5) * 2, 0.0, 1.0) * (_HEAD[:, 0] < 0.5) * (_HEAD[:, 0] > 0.0)
    forward = (_HEAD[:, 3] + 0.006 - 0.012 * long) * size
    centre = centre + skeleton.head_forward[:, None] * forward[..., None]
    return Rings(
        centre,
        np.broadcast_to(-skeleton.neck[:, None], centre.shape),
        left_of(skeleton.head_forward)[:, None],
        _HEAD[:, 1] * size * thick * (1 + 0.16 * long),
        _HEAD[:, 2] * size * thick * (1 + 0.16 * long),
    )


def _add_noses(vertices: Floats, figures: Figures, skeleton: Skeleton) -> None:
    """Pull one vertex in the middle of each face forward, in place."""
    head = TUBES[1]
    nose = TUBES[0].vertices + _NOSE_RING * (head.segments + 1) + head.segments // 2
    vertices[:, nose] += skeleton.head_forward * (_NOSE_M * figures.height_m)[:, None]


def _along(joints: tuple[Floats, Floats, Floats], share: Floats) -> Floats:
    """Points (n, r, 3) on a bent limb: 0 first joint, 1 second, 2 third; rounded at the bend."""
    a, b, c = (joint[:, None] for joint in joints)
    first = np.clip(share, None, 1.0)[None, :, None]
    second = np.clip(share - 1.0, 0.0, None)[None, :, None]
    point = a + (b - a) * first + (c - b) * second
    near = np.clip(1.0 - np.abs(share - 1.0) / 0.25, 0.0, 1.0)[None, :, None]
    return np.asarray(point + (0.06 * near) * ((a + c) / 2 - b))


def _arm(figures: Figures, skeleton: Skeleton, hand: int) -> Rings:
    joints = (skeleton.shoulder[:, hand], skeleton.elbow[:, hand], skeleton.wrist[:, hand])
    centre = _along(joints, _ARM[:, 0])
    size = (figures.height_m * figures.girth)[:, None]
    sleeve = np.where(_ARM[:, 0] < 1.92, figures.looseness[:, None], 1.0)
    side = left_of(skeleton.chest_forward)[:, None]
    return Rings(
        centre, directions(centre), side, _ARM[:, 1] * size * sleeve, _ARM[:, 2] * size * sleeve
    )


def _leg(figures: Figures, skeleton: Skeleton, leg: int) -> Rings:
    joints = (skeleton.hip[:, leg], skeleton.knee[:, leg], skeleton.ankle[:, leg])
    centre = _along(joints, _LEG[:, 0])
    size = (figures.height_m * np.sqrt(figures.girth))[:, None]
    lower = np.clip(_LEG[:, 0] / 1.6, 0.0, 1.0)[None]
    loose = 1.0 + (figures.trousers[:, None] - 1.0) * lower * 1.6
    # Thighs must not show through what hangs over them.
    hem = figures.skirt[:, None] / 0.245
    loose = np.where(_LEG[:, 0] < np.minimum(hem, 0.9), 0.72, loose)
    side = left_of(skeleton.forward)[:, None]
    return Rings(
        centre, directions(centre), side, _LEG[:, 1] * size * loose, _LEG[:, 2] * size * loose
    )


def _shoe(figures: Figures, skeleton: Skeleton, leg: int) -> Rings:
    size = figures.height_m[:, None]
    toe, sole = skeleton.toe[:, None, leg], skeleton.sole[:, None, leg]
    ahead = (_FOOT[:, 0] * size)[..., None]
    up = ((_FOOT[:, 2] - _ANKLE_OVER_SOLE) * size)[..., None]
    centre = skeleton.ankle[:, None, leg] + toe * ahead + sole * up
    return Rings(
        centre,
        np.broadcast_to(toe, centre.shape),
        np.cross(sole, toe),
        _FOOT[:, 1] * size,
        _FOOT[:, 2] * size,
    )


def _skirt(figures: Figures, skeleton: Skeleton) -> Rings:
    """A skirt or the skirts of a coat; without one, rings of no size that cover nothing."""
    size = figures.height_m[:, None]
    down = np.concatenate(([0.0], np.linspace(0.0, 1.0, _SKIRT_RINGS - 1)))[None]
    # The first ring lies inside the torso, or one could look into the skirt from above.
    inward = np.where(np.arange(_SKIRT_RINGS) == 0, 0.8, 1.0)
    top, _ = _upright(figures, skeleton, np.array([0.592]))
    knees = skeleton.knee.mean(axis=1)[:, None]
    knees = knees + (skeleton.hip.mean(axis=1)[:, None] - knees) * 0.25
    fall = (0.592 - 0.32) * size
    share = (down * figures.skirt[:, None] * size / fall)[..., None]
    centre = top + (knees - top) * share
    spread = np.linalg.norm(skeleton.knee[:, 0] - skeleton.knee[:, 1], axis=1)[:, None]
    flare = figures.flare[:, None]
    width = (0.096 * figures.hips[:, None] + 0.030 * flare * down) * size * figures.girth[:, None]
    depth = (0.069 + 0.026 * flare * down) * size * figures.girth[:, None]
    depth = depth + 0.48 * spread * share[..., 0]
    worn = (figures.skirt > 0)[:, None]
    return Rings(
        centre,
        np.broadcast_to(-UP, centre.shape),
        left_of(skeleton.forward)[:, None],
        np.where(worn, width * inward, 0.0),
        np.where(worn, depth * inward, 0.0),
    )


def _pack(figures: Figures, skeleton: Skeleton) -> Rings:
    """A backpack; without one, rings of no size that cover nothing."""
    centre, _ = _upright(figures, skeleton, _PACK[:, 0])
    scale = (figures.height_m * figures.pack)[:, None]
    # What is not worn hides in the body, so that boxes stay tight.
    worn = figures.pack > 0
    back = (0.105 * worn * figures.height_m * figures.girth)[:, None, None]
    outward = np.cross(left_of(skeleton.chest_forward), skeleton.spine)
    centre = centre - outward[:, None] * back
    return Rings(
        centre,
        np.broadcast_to(-UP, centre.shape),
        left_of(skeleton.chest_forward)[:, None],
        _PACK[:, 1] * scale,
        _PACK[:, 2] * scale,
    )


def profile_of(name: str) -> Floats:
    """How far down its texture patch each ring (r,) of a tube lies, 0..1."""
    if name == "torso":
        return np.asarray((_TORSO[0, 0] - _TORSO[:, 0]) / (_TORSO[0, 0] - _TORSO[-1, 0]))
    if name == "head":
        return np.clip(1.0 - _HEAD[:, 0], 0.0, 1.0)
    profile = {"arm": _ARM, "leg": _LEG, "shoe": _FOOT}.get(name.split()[-1])
    if profile is None:
        return np.linspace(0.0, 1.0, _PACK_RINGS if name == "pack" else _SKIRT_RINGS)
    along = profile[:, 0]
    return np.asarray((along - along[0]) / (along[-1] - along[0]))
