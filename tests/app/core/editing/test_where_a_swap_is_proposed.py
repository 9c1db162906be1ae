"""Where a swap is proposed from where the user looks."""

import numpy as np
import pytest
import two_people

from app.core.editing import EditFlow, edits, preview_plan, swap_candidates
from app.core.editing.correction import CorrectionPresenter
from app.core.editing.review_target import find_first_frame
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import RecordingGeometry
from app.core.tracks.selection import Selection
from tracking.editing import SwapFrame
from tracking.review import ReviewItem
from tracking.tracks import CORRECTED_COLUMNS, Labels, TrackTable


def test_of_frames_about_as_likely_the_nearest_comes_first():
    found = (SwapFrame(900, 0.4, "far"), SwapFrame(110, 0.3, "near"), SwapFrame(90, 0.05, "no"))
    assert [one.frame for one in swap_candidates.nearest_of_likely(found, 100)] == [110, 900, 90]


def test_one_that_is_much_likelier_stays_first():
    found = (SwapFrame(900, 0.9, "far"), SwapFrame(110, 0.1, "near"))
    assert [one.frame for one in swap_candidates.nearest_of_likely(found, 100)] == [900, 110]


def _said_of(apart_m: float, others: int, asked_at: int = 50) -> tuple[str, ...]:
    """What the panel says of the first frame found for two who stand so far apart."""
    on = EditContext(two_people.table(), Labels(), RecordingGeometry(None, 100, 10.0, (640, 480)))
    first = SwapFrame(50, 1.0 - 0.2 * others, "reasons", apart_m=apart_m)
    found = (first, *[SwapFrame(80, 0.2, "less")] * others)
    flow = EditFlow.begin(edits.SWAP, 4, asked_at, 10.0).with_other(7, found)
    return preview_plan(flow, on).scene.details


def test_of_several_frames_the_share_is_told():
    assert _said_of(0.3, others=1)[0] == "Frame 50 (00:05.00), 80 %: reasons"


def test_a_single_frame_is_told_as_the_only_one_found_and_not_as_certain():
    assert _said_of(0.3, others=0)[0] == "Frame 50 (00:05.00), the only frame found: reasons"


def test_two_who_are_far_apart_are_not_told_as_having_changed_over():
    said = _said_of(3.0, others=0)[0]
    assert said == "Frame 50 (00:05.00), unlikely here: reasons"


def test_it_says_why_the_edit_begins_elsewhere_than_where_it_was_asked_for():
    why = "Begins here, not in frame 44: of the frames nearby a swap is likeliest here"
    assert why in _said_of(0.3, others=1, asked_at=44)
    assert why not in _said_of(0.3, others=1)


def test_where_nothing_speaks_for_a_frame_that_is_said():
    found = (SwapFrame(50, 0.9, "reasons", False), SwapFrame(80, 0.1, "less"))
    on = EditContext(two_people.table(), Labels(), RecordingGeometry(None, 100, 10.0, (640, 480)))
    flow = EditFlow.begin(edits.SWAP, 4, 50, 10.0).with_other(7, found)
    said = preview_plan(flow, on).scene.details[0]
    assert said == "Frame 50 (00:05.00), no clear sign: reasons"


@pytest.fixture
def correcting():
    on = EditContext(two_people.table(), Labels(), RecordingGeometry(None, 100, 10.0, (640, 480)))
    selection = Selection()
    selection.choose(4)
    selection.add(7)
    return CorrectionPresenter(selection, on.geometry, lambda: on)


def _cut_proposed(correcting, tracks, frame, begun_at):
    one = ReviewItem("margin", tracks, frame, frame - 5, frame + 5, 0.5, 9.0, "why", "swap")
    correcting.item_looked_at = lambda: one
    correcting.begin(edits.SWAP, begun_at)
    return correcting.flow.cut


def test_a_flagged_swap_is_proposed_in_the_frame_of_its_review_item(correcting):
    assert _cut_proposed(correcting, (4, 7), 80, begun_at=75) == 80


def test_a_review_item_of_one_of_the_two_is_about_the_swap_too(correcting):
    assert _cut_proposed(correcting, (7,), 20, begun_at=20) == 20


def test_a_review_item_left_far_behind_or_of_somebody_else_changes_nothing(correcting):
    correcting.begin(edits.SWAP, 30)
    alone = correcting.flow.cut
    assert _cut_proposed(correcting, (4, 7), 80, begun_at=30) == alone != 80
    assert _cut_proposed(correcting, (4, 9), 30, begun_at=30) == alone


def _shown_at(tracks, frames_of, frame):
    rows = {"track": [], "frame": []}
    for track, (start, stop) in frames_of.items():
        rows["frame"] += range(start, stop)
        rows["track"] += [track] * (stop - start)
    order = np.lexsort((rows["track"], rows["frame"]))
    columns = {name: np.zeros(len(order), kind) for name, kind in CORRECTED_COLUMNS.items()}
    columns |= {name: np.array(rows[name])[order].astype(np.int32) for name in rows}
    one = ReviewItem("height", tracks, frame, frame - 5, frame + 5, 0.5, 9.0, "why", "split")
    return find_first_frame(one, TrackTable(columns))


def test_a_review_item_is_looked_at_from_just_before_where_its_people_are_there():
    assert _shown_at((4,), {4: (0, 100)}, 50) == 45


def test_who_begins_within_a_review_item_is_looked_at_from_there():
    assert _shown_at((4,), {4: (48, 100)}, 50) == 48


def test_of_two_both_must_be_there_unless_one_only_follows_the_other():
    assert _shown_at((4, 7), {4: (0, 100), 7: (48, 100)}, 50) == 48
    assert _shown_at((4, 7), {4: (0, 47), 7: (50, 100)}, 50) == 45


def test_a_review_item_of_somebody_who_is_not_there_by_now_is_looked_at_nearest_to_it():
    assert _shown_at((4,), {4: (70, 100)}, 50) == 70


def test_of_long_tracks_only_the_stretch_of_a_review_item_is_read(monkeypatch):
    rows = {name: np.zeros(40_000, kind) for name, kind in CORRECTED_COLUMNS.items()}
    rows["frame"] = np.repeat(np.arange(20_000, dtype=np.int32), 2)
    rows["track"] = np.tile(np.array([4, 7], np.int32), 20_000)
    read, both = [], np.intersect1d

    def noted(first, second):
        read.append(len(first) + len(second))
        return both(first, second)

    monkeypatch.setattr(np, "intersect1d", noted)
    one = ReviewItem("height", (4, 7), 500, 490, 510, 0.5, 9.0, "why", "split")
    assert find_first_frame(one, TrackTable(rows)) == 490
    assert max(read) <= 40
