"""Joints of walking people: legs reach for the feet, arms swing against them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.synthesis.figures import Figures

UP = np.array([0.0, 0.0, 1.0])

_HIP = 0.517  # heights of joints as shares of body height
_SHOULDER = 0.806
_THIGH, _SHANK = 0.245, 0.248
_UPPER_ARM, _FOREARM = 0.172, 0.147
_ANKLE = 0.042
_BALL, _HEEL = 0.062, 0.062  # from the foot's middle
_ANKLE_BACK = 0.034
_CROUCHED_RAD, _BENT_RAD = 0.60, 1.20  # how far the trunk tips forward
_NECK = 0.45  # and the head, against the trunk
_CROUCHED_DOWN, _BENT_DOWN = 0.27, 0.015  # how far the pelvis goes down, as shares of height
_CROUCHED_BACK, _BENT_BACK = 0.10, 0.09


@dataclass(frozen=True, slots=True, eq=False)
class Posture:
    """What people do in one frame, a row per person; feet are left, right.

    Attributes:
        position: (n, 2) world metres. heading: (n,) radians.
        foot: (n, 2, 2); yaw, lift_m, pitch: (n, 2); phase, pace: (n,), as `Steps` has them.
        crouch, bend: (n,) as `Stoops` has them.
    """

    position: Floats
    heading: Floats
    foot: Floats
    yaw: Floats
    lift_m: Floats
    pitch: Floats
    phase: Floats
    pace: Floats
    crouch: Floats
    bend: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Skeleton:
    """World positions of joints, (n, 3), and of pairs left, right, (n, 2, 3); metres.

    Attributes:
        pelvis: between the hip joints.
        forward, chest_forward, head_forward: (n, 3) unit vectors, level.
        lean: (n, 3) how far the body leans per metre of height.
        spine: (n, 3) unit vectors up the trunk, before it leans; straight up unless stooping.
        neck: (n, 3) the same for the neck and head.
        hip, knee, ankle, shoulder, elbow, wrist: joints.
        toe: (n, 2, 3) unit vectors from heel to toe; sole: unit vectors up from the sole.
    """

    pelvis: Floats
    forward: Floats
    chest_forward: Floats
    head_forward: Floats
    lean: Floats
    spine: Floats
    neck: Floats
    hip: Floats
    knee: Floats
    ankle: Floats
    shoulder: Floats
    elbow: Floats
    wrist: Floats
    toe: Floats
    sole: Floats


def skeleton_of(figures: Figures, posture: Posture) -> Skeleton:
    """The joints of people in a posture."""
    height, pace = figures.height_m, posture.pace
    sway = np.cos(2 * np.pi * posture.phase)
    forward = level(posture.heading + 0.10 * pace * -sway)
    chest_forward = level(posture.heading + 0.13 * pace * sway)
    pelvis = _pelvis(posture, height)
    lean = forward * (0.02 + 0.05 * pace)[:, None]
    ankle, toe, sole = _feet(posture, height)
    gap = left_of(forward)[:, None] * np.array([0.05, -0.05])[None, :, None]
    hip = pelvis[:, None] + gap * height[:, None, None]
    knee, ankle = _legs(hip, ankle, forward, toe, height)
    rise = (_SHOULDER - _HIP) * height[:, None]
    trunk = _CROUCHED_RAD * posture.crouch + _BENT_RAD * posture.bend
    spine = pitched(forward, trunk)
    chest = pelvis + spine * rise + lean * rise
    side = np.array([0.098, -0.098])[None, :, None] * (figures.shoulders * height)[:, None, None]
    shoulder = chest[:, None] + left_of(chest_forward)[:, None] * side
    elbow, wrist = _arms(shoulder, chest_forward, figures, posture)
    return Skeleton(
        pelvis=pelvis,
        forward=forward,
        chest_forward=chest_forward,
        head_forward=level(posture.heading + 0.25 * np.sin(0.9 * posture.phase + height * 40)),
        lean=lean,
        spine=spine,
        neck=pitched(forward, _NECK * trunk),
        hip=hip,
        knee=knee,
        ankle=ankle,
        shoulder=shoulder,
        elbow=elbow,
        wrist=wrist,
        toe=toe,
        sole=sole,
    )


def level(angle: Floats) -> Floats:
    """Level unit vectors (..., 3) in directions (...) given in radians."""
    return np.stack((np.cos(angle), np.sin(angle), np.zeros_like(angle)), axis=-1)


def left_of(forward: Floats) -> Floats:
    """Level unit vectors (..., 3) to the left of others."""
    return np.stack((-forward[..., 1], forward[..., 0], np.zeros(forward.shape[:-1])), axis=-1)


def pitched(forward: Floats, angle: Floats) -> Floats:
    """Unit vectors (n, 3) tipped forward from straight up by angles (n,) in radians."""
    return UP * np.cos(angle)[:, None] + forward * np.sin(angle)[:, None]


def _pelvis(posture: Posture, height: Floats) -> Floats:
    """The pelvis goes up and down twice a stride, lowest when both feet are on the floor.

    Who stoops moves it back, to keep the balance, and who crouches far down.
    """
    bob = -0.010 * posture.pace * np.cos(4 * np.pi * (posture.phase - 0.05))
    down = _CROUCHED_DOWN * posture.crouch + _BENT_DOWN * posture.bend
    z = (_HIP - 0.014 * posture.pace + bob - down) * height
    sway = 0.012 * posture.pace * np.sin(2 * np.pi * (posture.phase - 0.05))
    back = _CROUCHED_BACK * posture.crouch + _BENT_BACK * posture.bend
    ahead = level(posture.heading)
    place = posture.position + left_of(ahead)[:, :2] * (sway * height)[:, None]
    place = place - ahead[:, :2] * (back * height)[:, None]
    return np.column_stack((place, z))


def _feet(posture: Posture, height: Floats) -> tuple[Floats, Floats, Floats]:
    """Ankles and the directions of toes and out of the soles; feet roll over heel and ball."""
    ahead = level(posture.yaw)
    cos, sin = np.cos(posture.pitch)[..., None], np.sin(posture.pitch)[..., None]
    toe = ahead * cos - UP * sin
    sole = ahead * sin + UP * cos
    size = height[:, None, None]
    middle = np.concatenate((posture.foot, posture.lift_m[..., None]), axis=-1)
    on_ball = middle + ahead * _BALL * size - toe * (_BALL + _ANKLE_BACK) * size
    on_heel = middle - ahead * _HEEL * size + toe * (_HEEL - _ANKLE_BACK) * size
    ankle = np.where(posture.pitch[..., None] > 0, on_ball, on_heel) + sole * _ANKLE * size
    return ankle, toe, sole


def _legs(
    hip: Floats, ankle: Floats, forward: Floats, toe: Floats, height: Floats
) -> tuple[Floats, Floats]:
    """Knees and ankles (n, 2, 3); an ankle out of reach comes as near as the leg is long."""
    thigh, shank = _THIGH * height[:, None], _SHANK * height[:, None]
    gap = ankle - hip
    length = np.linalg.norm(gap, axis=-1)
    reach = np.minimum(length, 0.998 * (thigh + shank))
    along = gap / length[..., None]
    ankle = hip + along * reach[..., None]
    share = (reach**2 + thigh**2 - shank**2) / (2 * reach)
    out = np.sqrt(np.maximum(thigh**2 - share**2, 0.0))
    bend = forward[:, None] + 0.6 * toe
    bend = bend - (bend * along).sum(-1, keepdims=True) * along
    bend /= np.maximum(np.linalg.norm(bend, axis=-1, keepdims=True), 1e-6)
    return hip + along * share[..., None] + bend * out[..., None], ankle


def _arms(
    shoulder: Floats, forward: Floats, figures: Figures, posture: Posture
) -> tuple[Floats, Floats]:
    """Elbows and wrists (n, 2, 3)."""
    turn = 2 * np.pi * (posture.phase[:, None] + np.array([0.0, 0.5]))
    # The arm is back when the leg of its side is ahead.
    swing = 0.04 - 0.33 * posture.pace[:, None] * np.cos(turn)
    bend = 0.20 + 0.13 * posture.pace[:, None] * (1 - np.cos(turn))
    holds = figures.phone[:, None] * np.array([0.0, 1.0])
    swing = swing * (1 - holds) + holds * 0.45
    bend = bend * (1 - holds) + holds * 1.75
    swing = swing + 0.75 * posture.crouch[:, None]
    outward = left_of(forward)[:, None] * np.array([1.0, -1.0])[None, :, None]
    upper = _hanging(forward[:, None], outward, swing, 0.11)
    lower = _hanging(forward[:, None], outward, swing + bend, 0.02 - 0.2 * holds)
    size = figures.height_m[:, None, None]
    elbow = shoulder + upper * _UPPER_ARM * size
    return elbow, elbow + lower * _FOREARM * size


def _hanging(forward: Floats, outward: Floats, swing: Floats, spread: Floats | float) -> Floats:
    """Unit vectors that hang down, swung forward and spread outward by angles in radians."""
    tilt = np.asarray(spread, float)[..., None] * np.ones_like(swing)[..., None]
    hanging = forward * np.sin(swing)[..., None] - UP * np.cos(swing)[..., None]
    return np.asarray(hanging * np.cos(tilt) + outward * np.sin(tilt))
