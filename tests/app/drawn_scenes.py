"""Scenes to draw in tests."""

from __future__ import annotations

import numpy as np

from app.core.scenes import (
    FloorPerson,
    Lane,
    OverheadScene,
    PersonMark,
    PictureScene,
    Side,
    TimelineScene,
)

RED, BLUE = (220, 40, 40), (40, 80, 220)


def person(track: int, box: tuple[float, float, float, float], **changed: object) -> PersonMark:
    """A person in a picture; keywords replace single fields."""
    fields: dict[str, object] = {
        "track": track,
        "box": box,
        "label": str(track),
        "colour": RED,
        "selected": False,
        "predicted": False,
        "trail": np.zeros((0, 2)),
    }
    return PersonMark(**(fields | changed))


def picture(*people: PersonMark, bgr: tuple[int, int, int] = (200, 200, 200)) -> PictureScene:
    """A plain picture of 320 x 240 pixels."""
    return PictureScene(Side.LEFT, 7, np.full((240, 320, 3), bgr, np.uint8), people)


def floor_person(track: int, at: tuple[float, float], **changed: object) -> FloorPerson:
    """A person on the floor; keywords replace single fields."""
    fields: dict[str, object] = {
        "track": track,
        "label": str(track),
        "position": at,
        "velocity": (0.0, 0.0),
        "colour": RED,
        "selected": False,
        "predicted": False,
        "trail": np.zeros((0, 2)),
    }
    return FloorPerson(**(fields | changed))


def overhead(*people: FloorPerson, **changed: object) -> OverheadScene:
    """Ten metres of floor; keywords replace single fields."""
    fields: dict[str, object] = {
        "frame": 7,
        "particles": np.zeros((0, 2), np.float32),
        "particle_colours": np.zeros((0, 3), np.uint8),
        "particle_weights": np.zeros(0, np.float32),
        "measured": np.zeros((0, 2)),
        "people": people,
        "field_of_view": np.zeros((0, 2)),
        "camera": (0.0, 0.0),
        "bounds": (-5.0, 0.0, 5.0, 10.0),
    }
    return OverheadScene(**(fields | changed))


def lane(track: int, *spans: tuple[int, int, int], **changed: object) -> Lane:
    """A lane; keywords replace single fields."""
    fields: dict[str, object] = {
        "track": track,
        "label": str(track),
        "colour": RED,
        "selected": False,
        "spans": np.array(spans or [(0, 1000, 0)], np.int64),
    }
    return Lane(**(fields | changed))


def timeline(*lanes: Lane, frame: int = 0, count: int = 1000, **changed: object) -> TimelineScene:
    """A recording of twenty frames a second; keywords replace single fields."""
    fields: dict[str, object] = {
        "frame_count": count,
        "fps": 20.0,
        "frame": frame,
        "lanes": lanes,
        "activity": np.ones(count, np.uint16),
    }
    return TimelineScene(**(fields | changed))
