"""A merge offers people who come before or after the selected one, not those beside them."""

import numpy as np
import two_people

from app.core.editing import edits
from app.core.editing.correction import CorrectionPresenter
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import RecordingGeometry
from app.core.tracks.selection import Selection
from tracking.tracks import Labels, TrackTable

SPANS = {4: (40, 60), 7: (30, 70), 1: (0, 38), 2: (62, 100), 3: (80, 100), 5: (62, 90)}
"""Track 7 is there beside track 4; the others are before or after it."""
PLACES = {4: 0.0, 7: 0.2, 1: 0.1, 2: 8.0, 3: 0.3, 5: 0.4}


def _merging(on_floor=True):
    """A merge of track 4 begun in frame 50."""
    all_rows = two_people.columns()
    parts = []
    for track, (start, end) in SPANS.items():
        one = {name: column[all_rows["track"] == 4][start:end] for name, column in all_rows.items()}
        x = np.full(end - start, PLACES[track], np.float32)
        one |= {"track": np.full(end - start, track, np.int32), "left": 300 + 47 * x}
        parts.append(one | {"x": x if on_floor else np.full_like(x, np.nan)})
    rows = {name: np.concatenate([part[name] for part in parts]) for name in all_rows}
    order = np.lexsort((rows["track"], rows["frame"]))
    table = TrackTable({name: column[order] for name, column in rows.items()})
    on = EditContext(table, Labels(), RecordingGeometry(None, 100, 10.0, (640, 480)))
    selection = Selection()
    selection.choose(4)
    correcting = CorrectionPresenter(selection, on.geometry, lambda: on)
    correcting.begin(edits.MERGE, 50)
    return correcting


def test_those_before_and_after_are_offered_the_nearest_in_time_and_place_first():
    assert _merging().flow.others == (1, 5, 3, 2)


def test_without_a_floor_boxes_tell_who_is_near():
    assert _merging(on_floor=False).flow.others == (1, 5, 3, 2)


def test_tab_goes_through_those_alone():
    correcting, seen = _merging(), []
    for _ in range(5):
        correcting.pick_next([4, 7], 1)
        seen.append(correcting.flow.other)
    assert seen == [1, 5, 3, 2, 1]
