"""Frames spread evenly over a recording."""

from __future__ import annotations

from tracking.recording.spread_frames import spread_frames


def test_frames_are_spread_from_the_first_to_the_last_and_told_once_worked_on() -> None:
    told: list[tuple[int, int]] = []
    frames = spread_frames(100, 4, lambda *step: told.append(step))
    assert next(frames) == 0
    assert told == []
    assert list(frames) == [33, 66, 99]
    assert told == [(1, 4), (2, 4), (3, 4), (4, 4)]


def test_of_a_short_recording_all_are_taken() -> None:
    assert list(spread_frames(3, 15)) == [0, 1, 2]
