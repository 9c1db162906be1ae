"""When review items are looked for."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from app.features.review.review_search import ReviewSearch
from tracking.recording import open_recording
from tracking.tracks import Labels, Run, TrackTable


def test_it_says_that_it_looks_from_the_moment_it_is_asked(
    qtbot: QtBot, tiny_recording: Path, tiny_run: Run
) -> None:
    owner = QObject()
    with open_recording(tiny_recording) as recording:
        search = ReviewSearch(
            lambda: (TrackTable(tiny_run.tracks), tiny_run, Labels()), recording, owner
        )
        assert not search.doing
        search.look()
        assert search.doing == "Looking for review items..."
        with qtbot.waitSignal(search.found, timeout=30_000):
            pass
        assert not search.doing
        search.look()
        search.stop()
        assert not search.doing
