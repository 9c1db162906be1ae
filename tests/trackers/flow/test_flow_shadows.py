"""The flow tracker leaves shadows alone, learns them beside people, and knows where people are."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest
from flow_scenes import (
    FPS,
    SIZE,
    drawn,
    floor_picture,
    frame_of,
    straight,
    tracked,
    view_of,
)
from numpy.typing import NDArray

from tracking.foreground import BodyMasks, ShadowWeights
from tracking.trackers.flow.body_masks import body_masks
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.perception import FlowPerception
from tracking.trackers.flow.silhouettes import SHADE
from tracking.trackers.flow.walkers import Walkers, begin_walkers, mark_proven

VIEW = view_of()
FLOOR = np.asarray(0.3 * floor_picture() + 120, np.uint8)
FRAMES = 20
WAY = straight((-0.6, 4.6), (0.8, 0.0), FRAMES)
FALLS = np.array((1.2, -0.9))
"""Where the shadow of a head falls, m from the feet."""
SKY = (0.85, 0.7, 0.62)
"""Share of the light that is left in the shade, BGR: what comes from a blue sky."""
ASIDE = np.array((0.12, 0.16))


def shadow_of(place: NDArray[np.float64]) -> NDArray[np.int32]:
    """(4, 2) px: the corners of the shadow of somebody who stands there."""
    corners = np.stack((place - ASIDE, place + ASIDE, place + FALLS + ASIDE, place + FALLS - ASIDE))
    pixels = VIEW.pixel_from_world(np.column_stack((corners, np.zeros(4))))
    return np.rint(pixels).astype(np.int32)


def shaded(floor: NDArray[np.uint8], place: NDArray[np.float64]) -> NDArray[np.uint8]:
    light = np.ones(floor.shape, np.float32)
    cv2.fillConvexPoly(light, shadow_of(place), SKY)
    return np.asarray(floor * cv2.GaussianBlur(light, (0, 0), 1.0), np.uint8)


@pytest.mark.parametrize("told", [True, False])
def test_what_lies_beside_people_all_the_while_is_shadow(told: bool) -> None:
    perception = FlowPerception(FPS)
    perception.learn([frame_of(0, FLOOR)] * 2)
    nobody = np.zeros((SIZE[1] // 2, SIZE[0] // 2), np.uint8)
    for number in range(60):
        place = np.array((-1.5 + 0.05 * number, 4.6))
        mask = perception.observe(frame_of(number, shaded(FLOOR, place))).mask
        shadow = cv2.fillConvexPoly(nobody.copy(), shadow_of(place) // 2, 255)
        if told:
            perception.tell(BodyMasks(nobody, shadow, shadow))
    assert (mask[shadow > 0] > 0).mean() > 0.9
    as_shade = (mask[shadow > 0] == SHADE).mean()
    assert as_shade > 0.7 if told else as_shade < 0.3


def test_points_in_shadows_are_not_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    pictures = [drawn(FLOOR, VIEW, [(*place, 10)]) for place in WAY]
    steps, _ = tracked(VIEW, pictures, background=FLOOR)
    assert all(len(step.tracklets["u0"]) > 20 for step in steps[10:])
    monkeypatch.setattr(ShadowWeights, "weigh", lambda _, seen: np.zeros_like(seen.mask))
    steps, _ = tracked(VIEW, pictures, background=FLOOR)
    assert not any(len(step.tracklets["u0"]) for step in steps)


def test_masks_say_where_bodies_are_and_where_their_shadows_may_fall() -> None:
    floor = Floor(VIEW)
    here = np.array(((0.0, 4.0),))
    new = begin_walkers(np.ones(1, np.int32), here, np.zeros((1, 2)))
    masks = body_masks(new, floor)
    assert masks.kept.any()
    assert not masks.on.any()  # who has just begun may be nobody
    assert not masks.beside.any()
    masks = body_masks(_known(new), floor)

    def at(x: float, y: float, z: float) -> tuple[int, int]:
        u, v = VIEW.pixel_from_world(np.array(((x, y, z),)))[0] / 2
        return int(v), int(u)

    chest, beside_feet, far = at(0, 4, 1.3), at(1.5, 4, 0), at(2.5, 4, 0)
    assert masks.on[chest]
    assert masks.kept[chest]
    assert masks.kept[at(0, 4, 0.1)]
    assert masks.beside[beside_feet]
    assert not masks.beside[chest]
    assert not masks.on[at(0.0, 4.0, 0.2)]  # shadows lie there
    assert not any(mask[far] for mask in (masks.on, masks.beside, masks.kept))


def _known(walkers: Walkers) -> Walkers:
    """Somebody who has walked for a while."""
    return mark_proven(
        replace(walkers, age_s=walkers.age_s + 10 / FPS, began=walkers.began - 3), 0.5
    )
