"""Work of a panel's own."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from app.core.widgets import work_line
from app.core.widgets.work_line import WorkLine


@pytest.fixture
def now_s(monkeypatch):
    """The time, to be changed."""
    now = [100.0]
    monkeypatch.setattr(work_line, "time", SimpleNamespace(monotonic=lambda: now[0]))
    return now


def test_it_tells_how_long_its_work_still_takes(qtbot, now_s):
    line = WorkLine("Cancel the search")
    qtbot.addWidget(line)
    line.show_work("Searching", 0.0)
    assert line._left.text() == ""
    now_s[0] += 10.0
    line.show_work("Searching", 0.25)
    assert line._left.text() == "30 s left"
    line.show_work("Writing", 0.5)  # of other work nothing is known yet
    assert line._left.text() == ""
    line.show_work("")
    assert line.isHidden()


def test_the_same_work_once_more_takes_its_own_time(qtbot, now_s):
    line = WorkLine("Cancel the search")
    qtbot.addWidget(line)
    line.show_work("Searching", 0.9)
    line.show_work("")
    now_s[0] += 100.0
    line.show_work("Searching", 0.5)
    now_s[0] += 2.0
    line.show_work("Searching", 0.5)
    assert line._left.text() == "2 s left"
