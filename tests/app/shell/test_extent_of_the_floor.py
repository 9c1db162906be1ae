"""How far the floor is shown."""

import numpy as np
import pytest

from app.core.document.document import Document
from app.core.projection.extent import extent, full_extent, unite
from app.shell.recording_scenes import RecordingScenes
from tracking.recording import open_recording
from tracking.session import Session


def rows(*places):
    x, y = np.array(places, np.float32).reshape(-1, 2).T
    return {"x": x, "y": y}


def test_it_reaches_in_whole_metres_around_everybody():
    assert extent(rows((-1.0, 2.0), (3.2, 11.7)), 8.0) == (-2.0, 1.0, 4.0, 13.0)


def test_places_that_are_not_known_or_near_the_horizon_do_not_count():
    assert extent(rows((0.0, 2.0), (np.nan, np.nan), (5.0, 900.0)), 8.0) == (-1.0, 1.0, 1.0, 3.0)
    assert extent(rows((np.nan, np.nan)), 8.0) is None
    assert extent(rows(), 8.0) is None


def test_a_few_places_far_from_where_most_are_do_not_count_and_are_known_all_the_same():
    near = [(x / 10.0, 5.0 + x / 10.0) for x in range(100)]
    far = [(4.0, 29.0), (5.0, 30.0)]
    assert extent(rows(*near, *far), 8.0) == extent(rows(*near, (4.0, 19.5)), 8.0)
    assert full_extent(rows(*near, *far), 8.0)[3] == 31.0


def test_an_edit_of_who_is_far_away_leaves_the_map_as_it_is(document):
    floor = RecordingScenes(document).overhead
    near = [(x / 10.0, 5.0) for x in range(100)]
    floor.take(rows(*near, (0.0, 28.0)))
    before = floor.bounds
    assert before[3] < 28.0
    floor.take_more(rows((0.0, 28.0)))
    assert floor.bounds == before


def test_what_lies_within_changes_nothing():
    bounds = (-5.0, 0.0, 5.0, 10.0)
    assert unite(bounds, None) == unite(bounds, (-1.0, 1.0, 1.0, 3.0)) == bounds


@pytest.fixture
def document(tiny_recording, tiny_session):
    with open_recording(tiny_recording) as recording:
        document = Document(recording, Session.open(tiny_session))
        yield document
        document.session.close()


def test_the_map_grows_with_tracks_that_are_taken_and_begins_anew_with_others(document):
    floor = RecordingScenes(document).overhead
    before = floor.bounds
    top = before[3]
    floor.take_more(rows((0.0, top + 3.0)))
    assert floor.bounds[3] > top + 3.0
    assert floor.bounds[:3] == before[:3]
    floor.take(rows())
    assert floor.bounds[3] < top + 3.0


def test_all_tracks_of_a_session_are_on_the_map(document):
    left, bottom, right, top = RecordingScenes(document).overhead.bounds
    columns = document.session.tracks.columns()
    known = np.isfinite(columns["x"])
    x, y = columns["x"][known], columns["y"][known]
    assert len(x)
    assert left < x.min() < x.max() < right
    assert bottom < y.min() < y.max() < top
