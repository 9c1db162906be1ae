"""Who leaves takes the id along, and nobody is seen where hardly anything is foreground."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from people_of_one_colour import BLUE, RED, Body, followed, frames_of, places, standing, view

from tracking.geometry import FlatView
from tracking.trackers.spheroid import births, support
from tracking.trackers.spheroid.births import find_candidates
from tracking.trackers.spheroid.floor_cells import FloorCells

STAYS = (-3.3, 4.4)
"""Near the picture's edge, which is at -4.2 m there."""
LEAVES_FROM = (-0.9, 3.7)
FRAMES, GONE = 60, 40


def _leaving() -> np.ndarray:
    """(frames, 2) m of somebody who walks out of the picture, close by who stays."""
    return np.asarray(LEAVES_FROM) + np.arange(FRAMES)[:, None] / 15.0 * np.array((-1.5, 0.0))


def _ids_at_first_and_at_last(colour: tuple[int, int, int]) -> tuple[int, set[int]]:
    """The id of who stays while both are there, and all ids after the other one has gone."""
    seen_by = view(4.0, 40.0)
    bodies = [Body(standing(STAYS, FRAMES), colour), Body(_leaving())]
    results = followed(seen_by, frames_of(seen_by, bodies))
    first = results[10]
    assert len(first.tracks["track"]) == 2
    apart = np.hypot(*(places(first) - STAYS).T)
    last = {int(track) for result in results[GONE + 10 :] for track in result.tracks["track"]}
    return int(first.tracks["track"][apart.argmin()]), last


@pytest.mark.parametrize("colour", [RED, BLUE], ids=["alike", "in other clothes"])
def test_the_id_of_who_leaves_does_not_go_over_to_a_neighbour(colour: tuple[int, int, int]) -> None:
    stays, last = _ids_at_first_and_at_last(colour)
    assert last == {stays}


def test_without_letting_go_of_who_is_out_of_sight_the_id_stays(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(support, "_LEFT", -1.0)
    monkeypatch.setattr(support, "_EMPTY_S", 60.0)
    stays, last = _ids_at_first_and_at_last(RED)
    assert last - {stays}


def _places(ramp: np.ndarray) -> np.ndarray:
    """(n, 2) m of newcomers by the foreground that a low camera sees."""
    flat = FlatView(view(1.2, 0.0, focal=300.0))
    everywhere = np.ones(ramp.shape, bool)
    cells = FloorCells(flat, 1.72, 0.25)
    found = find_candidates(ramp, everywhere, cells, np.zeros((0, 2)), everywhere)
    return np.array([place.xy for place in found]).reshape(-1, 2)


def test_no_giant_is_seen_near_the_camera_where_a_little_is_foreground(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A bag at the picture's lower edge fills a part of the silhouette of somebody at 1 m."""
    ramp = np.zeros((240, 320), np.uint8)
    cv2.rectangle(ramp, (140, 190), (200, 239), 255, -1)
    assert not (np.hypot(*_places(ramp).T) < 2.5).any()
    monkeypatch.setattr(births, "_BALANCE", 0.0)
    assert (np.hypot(*_places(ramp).T) < 2.5).any()
