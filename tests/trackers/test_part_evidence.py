"""What speaks for a part being where its rectangle is."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.people import Detections
from tracking.trackers.three_part.claims import claims_of
from tracking.trackers.three_part.evidence import measure_evidence
from tracking.trackers.three_part.initiation import begin_people
from tracking.trackers.three_part.people import Layout, PartPeople
from tracking.tracks import PART_EVIDENCE

LAYOUT = Layout(parts=3, together=1)
PARTS = np.array([[[50, 30, 10, 12], [50, 60, 20, 30], [50, 100, 18, 30]]], float)


def _picture() -> np.ndarray:
    """Grey, with a person of three colours from row 20 to 139, 20 px to either side of 50."""
    picture = np.full((160, 200, 3), 128, np.uint8)
    for rows, colour in (((20, 40), 30), ((40, 80), 90), ((80, 140), 200)):
        picture[rows[0] : rows[1], 35:65] = colour
    return picture


def _seen() -> Detections:
    regions = np.zeros((160, 200), np.int32)
    regions[20:140, 35:65] = 1
    none = Detections.none((160, 200))
    rows = {
        name: np.zeros((1, *getattr(none, name).shape[1:]), getattr(none, name).dtype)
        for name in none.__slots__
        if name != "regions"
    }
    rows["box"][:] = (35, 20, 30, 120)
    return Detections(**rows, regions=regions)


def _people(rectangles: np.ndarray = PARTS) -> PartPeople:
    random = np.random.default_rng(0)
    track, pace = np.array([1], np.int32), np.zeros((1, 2))
    people = begin_people(track, PARTS, pace, _picture(), LAYOUT, random)
    state = people.state.copy()
    state[..., :4] = rectangles
    return people.replace(state=state)


def _evidence(people: PartPeople) -> dict[str, np.ndarray]:
    seen = _seen()
    measured = measure_evidence(people, seen, claims_of(people.rectangles, seen), _picture())
    return {name: measured[0, :, at] for at, name in enumerate(PART_EVIDENCE)}


def test_parts_in_their_places_are_on_foreground_of_their_own_colours() -> None:
    told = _evidence(_people())
    assert told["support"].tolist() == [1, 1, 1]
    assert told["likeness"] == pytest.approx([1, 1, 1], abs=1e-3)
    assert told["offset"] == pytest.approx([0, 0, 0], abs=1e-6)
    assert told["below"].tolist() == [1, 1, 1]
    assert told["above"][0] < 0.5


def test_a_head_beside_the_person_has_none_of_it() -> None:
    moved = PARTS.copy()
    moved[0, 0, 0] = 120
    told = _evidence(_people(moved))
    assert told["support"].tolist() == [0, 1, 1]
    assert told["likeness"][0] < 0.5 < told["likeness"][1]
    assert told["offset"][0] > 0.4 > told["offset"][1]
    assert [told[name][0] for name in ("above", "below", "beside")] == [0, 0, 0]


def test_foreground_that_is_somebody_elses_alone_speaks_for_nobody() -> None:
    seen, people = _seen(), _people()
    claims = claims_of(people.rectangles, seen)
    share = np.vstack((claims.share * 0.0, claims.share))
    two = type(claims)(
        share,
        np.repeat(claims.support, 2, axis=0),
        np.array([-1, 0]),
        np.array([False, True]),
    )
    pair = people.select(np.array([0, 0]), LAYOUT.filters)
    measured = measure_evidence(pair, seen, two, _picture())
    assert measured[:, 0, PART_EVIDENCE.index("support")].tolist() == [0, 1]


def test_nobody_has_no_evidence() -> None:
    nobody = _people().select(np.zeros(0, np.intp), LAYOUT.filters)
    seen = _seen()
    measured = measure_evidence(nobody, seen, claims_of(nobody.rectangles, seen), _picture())
    assert measured.shape == (0, 3, 8)
