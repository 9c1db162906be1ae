"""Which end of a track a run does without is told by frames, whatever the language."""

from dataclasses import replace
from pathlib import Path

import pytest
from two_people import table

from app.features.comparison.difference_search import ComparisonResult
from app.features.comparison.presenter import Comparison
from tracking.editing import Difference
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import Run


@pytest.mark.parametrize(
    ("start", "end", "title"),
    [(0, 20, "Later"), (70, 80, "Earlier"), (0, 80, "Gone"), (30, 40, "Gone")],
)
def test_who_is_gone_at_one_end_alone_is_found_later_or_ends_earlier(
    start: int, end: int, title: str, tiny_recording: Path, tiny_run: Run
):
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [tiny_run])
    session.add_run(replace(tiny_run, seed=7), adopt=False)
    assert tiny_run.frames == (0, 80)  # shorter than the track, which has all 100
    compared = Comparison(session, 1, None, 25.0, colour_of=lambda _: (1, 2, 3))
    one = Difference(4, 0, start, end, "removed", "4 fehlt", False, end - start)
    compared.take(ComparisonResult((one,), table(), table()))
    assert compared.scene().items[0].title == title
