"""Where a swap is proposed from where the user looks."""

import numpy as np
import two_people

from app.presenters.correcting import EditFlow, EditKind, Footing, Ground, cuts, planned_edit
from tracking.editing import SwapFrame
from tracking.tracks import Labels, TrackTable


def test_of_frames_about_as_likely_the_nearest_comes_first():
    found = (SwapFrame(900, 0.4, "far"), SwapFrame(110, 0.3, "near"), SwapFrame(90, 0.05, "no"))
    assert [one.frame for one in cuts.nearest_of_likely(found, 100)] == [110, 900, 90]


def test_one_that_is_much_likelier_stays_first():
    found = (SwapFrame(900, 0.9, "far"), SwapFrame(110, 0.1, "near"))
    assert [one.frame for one in cuts.nearest_of_likely(found, 100)] == [900, 110]


def _said_of(apart_m: float, others: int) -> str:
    """What the panel says of the first frame found for two who stand so far apart."""
    rows = dict(two_people.columns())
    late = rows["track"] == 7
    rows["y"] = np.where(late, 5.0 + apart_m, rows["y"]).astype(rows["y"].dtype)
    on = Ground(TrackTable(rows), Labels(), Footing(None, 100, 10.0, (640, 480)))
    found = (SwapFrame(50, 1.0 - 0.2 * others, "reasons"), *[SwapFrame(80, 0.2, "less")] * others)
    flow = EditFlow.begin(EditKind.SWAP, 4, 50, 10.0).with_other(7, found)
    return planned_edit(flow, on).scene.details[0]


def test_of_several_frames_the_share_is_told():
    assert _said_of(0.3, others=1) == "Frame 50 (00:05.00), 80 %: reasons"


def test_a_single_frame_is_told_as_the_only_one_found_and_not_as_certain():
    assert _said_of(0.3, others=0) == "Frame 50 (00:05.00), the only frame found: reasons"


def test_two_who_are_far_apart_are_not_told_as_having_changed_over():
    said = _said_of(3.0, others=0)
    assert said == "Frame 50 (00:05.00), nothing shows that they changed over: reasons"
