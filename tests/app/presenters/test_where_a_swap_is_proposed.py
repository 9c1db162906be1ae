"""Where a swap is proposed from where the user looks."""

from app.presenters.correcting import cuts
from tracking.editing import SwapFrame


def test_of_frames_about_as_likely_the_nearest_comes_first():
    found = (SwapFrame(900, 0.4, "far"), SwapFrame(110, 0.3, "near"), SwapFrame(90, 0.05, "no"))
    assert [one.frame for one in cuts.nearest_of_likely(found, 100)] == [110, 900, 90]


def test_one_that_is_much_likelier_stays_first():
    found = (SwapFrame(900, 0.9, "far"), SwapFrame(110, 0.1, "near"))
    assert [one.frame for one in cuts.nearest_of_likely(found, 100)] == [900, 110]
