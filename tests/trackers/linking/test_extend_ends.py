"""People stand in finished runs from when they were first detected until they were last."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from tests.trackers.linking.linked_runs import (
    FPS,
    VIEW,
    Stretch,
    ids_at,
    link_run,
    run_of,
    straight,
)
from tracking.trackers.linking import Finisher, extend_ends_in_pixels
from tracking.tracks import Columns, Run

WAY = straight((-1.5, 6), (1.5, 6), 80)


def known_late_and_lost_early(frames: Sequence[int]) -> Run:
    """Somebody detected all the way, and followed in these of its frames only."""
    run = run_of(Stretch(1, 0, WAY), frames=100)
    return replace(
        run,
        tracks=_of(run.tracks, frames),
        associations=_of(run.associations, frames),
        signals=_of(run.signals, frames),
        detections={
            **run.detections,
            "track": np.where(np.isin(run.detections["frame"], frames), 1, 0).astype(np.int32),
        },
    )


def _of(columns: Columns, frames: Sequence[int]) -> Columns:
    """The rows of these frames."""
    rows = np.isin(columns["frame"], frames)
    return {name: column[rows] for name, column in columns.items()}


def test_who_was_detected_before_the_tracker_was_sure_and_after_is_told_of_all_the_way() -> None:
    run = link_run(known_late_and_lost_early(range(8, 70)), VIEW, FPS)
    assert run.tracks["frame"].tolist() == list(range(80))
    assert not run.tracks["predicted"].any()
    assert np.allclose([ids_at(run, 2)[1][0], ids_at(run, 77)[1][0]], WAY[[2, 77], 0], atol=0.1)


def test_every_table_tells_of_the_rows_that_people_reach() -> None:
    run = link_run(known_late_and_lost_early(range(8, 70)), VIEW, FPS)
    assert run.detections["track"].tolist() == [1] * 80
    for table in (run.associations, run.signals):
        assert table["frame"].tolist() == list(range(80))
    assert np.isnan(run.associations["total"][:8]).all()


def test_detections_after_a_break_are_not_somebodys_from_before() -> None:
    tracked = known_late_and_lost_early(range(20, 80))
    kept = [*range(12), *range(20, 80)]
    run = link_run(replace(tracked, detections=_of(tracked.detections, kept)), VIEW, FPS)
    assert run.tracks["frame"].min() == 20


@pytest.mark.parametrize("shift", [(0.0, 2.0), (1.5, 0.0)])
def test_detections_elsewhere_are_nobodys(shift: tuple[float, float]) -> None:
    tracked = known_late_and_lost_early(range(8, 80))
    seen = {name: column.copy() for name, column in tracked.detections.items()}
    place = np.stack((seen["x"], seen["y"]), axis=1)[:8] + shift
    box = VIEW.box_of_person(place, 1.7, 0.5)
    names = ("x", "y", "left", "top", "width", "height")
    for name, column in zip(names, (*place.T, *box.T), strict=True):
        seen[name][:8] = column
    run = link_run(replace(tracked, detections=seen), VIEW, FPS)
    assert run.tracks["frame"].min() == 8


def test_where_no_floor_is_known_boxes_alone_lead_tracks_on() -> None:
    tracked = known_late_and_lost_early(range(8, 70))
    nowhere = {name: np.full(80, np.nan, np.float32) for name in ("x", "y")}
    run = replace(tracked, detections={**tracked.detections, **nowhere})
    finished = Finisher(extend_in_pixels=extend_ends_in_pixels).finish(run, None, FPS)
    assert finished.tracks["frame"].tolist() == list(range(80))
    assert np.isnan(finished.tracks["x"][[0, 79]]).all()


def test_without_floor_a_tracker_that_needs_one_keeps_its_tracks_as_they_were() -> None:
    run = known_late_and_lost_early(range(8, 70))
    assert link_run(run, None, FPS) is run
