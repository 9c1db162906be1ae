"""Labels are values: another one after each change."""

from __future__ import annotations

from tracking.tracks import Labels, ReviewedRange, TrackLabel


def test_a_track_nobody_spoke_of_has_an_empty_label() -> None:
    assert Labels().of_track(4) == TrackLabel()
    assert Labels().title(4) == "4"


def test_a_label_is_kept_beside_the_old_labels() -> None:
    before = Labels()
    after = before.with_track(4, TrackLabel("red coat", {"bag": "yes"}))
    assert after.title(4) == "4 red coat"
    assert before.tracks == {}


def test_an_emptied_label_leaves_nothing_behind() -> None:
    labels = Labels().with_track(4, TrackLabel("red coat")).with_track(4, TrackLabel())
    assert labels == Labels()


def test_a_range_reviewed_for_all_tracks_counts_for_each() -> None:
    labels = Labels(reviewed=(ReviewedRange(0, 5, 10), ReviewedRange(3, 10, 20)))
    assert labels.is_reviewed(7, 5)
    assert not labels.is_reviewed(7, 10)
    assert labels.is_reviewed(3, 19)
    assert not labels.is_reviewed(3, 20)
