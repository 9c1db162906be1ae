"""Scoring, counting, the review search and suggestions stand in the list of work, like all else."""

from __future__ import annotations

import threading

import pytest
from correcting_window import Hands, open_for_correcting
from PySide6.QtCore import Qt

from app.core.jobs.job_list import JobState
from app.core.widgets.jobs_dialog import JobsDialog
from app.features.counting.controller import CountController
from app.features.scoring.panel import ScorePanel
from tracking.editing import plan_lines
from tracking.review import ReviewItemFinder
from tracking.tracks import CountingLine

Key, SHIFT, ALT = Qt.Key, Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.AltModifier
GATE = CountingLine("gate", (1.0, -1.0), (1.2, 9.0))


@pytest.fixture
def hands(window, qtbot, parted_session):
    return Hands(window, open_for_correcting(window, qtbot, parted_session), qtbot)


@pytest.fixture
def slow(monkeypatch):
    """Makes a function take its time until it is let through; it hears Cancel as before."""
    go_on = threading.Event()

    def make(place, name, at=-1):
        work = getattr(place, name)

        def slowly(*args, **values):
            report = values.get("report", args[at])
            while not go_on.wait(0.01):
                report(1, 4)
            return work(*args, **values)

        monkeypatch.setattr(place, name, slowly)

    yield make, go_on
    go_on.set()


@pytest.fixture
def line(window):
    """The line of the list with a title; None where there is none."""
    return lambda title: next((one for one in window.work.jobs.lines if one.title == title), None)


def test_scoring_is_listed_cancelled_and_begun_again_from_the_list(
    hands, window, slow, line, qtbot
):
    make_slow, go_on = slow
    make_slow(window_module("scoring"), "score_subject")
    hands.press(Key.Key_S, SHIFT)
    qtbot.waitUntil(lambda: line("Scoring") is not None)
    assert line("Scoring").share == 0.25
    line("Scoring").cancel()
    panel = window.workspace.of(ScorePanel)
    qtbot.waitUntil(lambda: line("Scoring").state is JobState.STOPPED)
    qtbot.waitUntil(lambda: any("Cancelled" in text for text in texts(panel)))
    assert panel.table.rowCount() == 0 or panel.table.isHidden()
    go_on.set()
    window.show_jobs()
    dialog = window.findChild(JobsDialog)
    row = next(one for one in dialog._rows.values() if one._title.text() == "Scoring")
    row._again.click()
    qtbot.waitUntil(lambda: panel.table.isVisible() and panel.table.item(0, 0) is not None)
    assert panel.table.item(0, 0).text() == "HOTA"
    dialog.close()


def test_counting_is_listed_and_cancelled_from_the_list(hands, window, slow, line, qtbot):
    make_slow, _ = slow
    make_slow(window_module("counting"), "count_subject")
    document = hands.controller.document
    document.apply(plan_lines(document.session.labels, [GATE]))
    window.run_command("view.counting")
    hands.controller.draw()
    qtbot.waitUntil(lambda: line("Counting") is not None)
    assert line("Counting").share == 0.25
    line("Counting").cancel()
    qtbot.waitUntil(lambda: line("Counting").state is JobState.STOPPED)
    counting = hands.controller.of(CountController)
    qtbot.waitUntil(lambda: "starts it again" in counting.presenter.refused)


def test_the_review_search_is_listed_cancelled_and_begun_again(hands, window, slow, line, qtbot):
    make_slow, go_on = slow
    qtbot.waitUntil(lambda: not hands.controller.reviewing._updates.search.busy)
    make_slow(ReviewItemFinder, "find", at=6)
    title = "Looking for review items"
    hands.controller.reviewing._updates.search.look(at_once=True)
    qtbot.waitUntil(lambda: line(title) is not None)
    line(title).cancel()
    qtbot.waitUntil(lambda: line(title).state is JobState.STOPPED)
    assert "starts it again" in hands.controller.reviewing._updates.search.problem
    go_on.set()
    line(title).again()
    qtbot.waitUntil(lambda: not hands.controller.reviewing._updates.search.busy)
    assert hands.controller.reviewing._updates.search.problem == ""
    assert line(title) is None


def test_suggestions_are_listed_and_cancelled_from_the_list(hands, slow, line, qtbot):
    make_slow, _ = slow
    from app.features.labelling import suggestion_search

    make_slow(suggestion_search, "suggest")
    hands.press(Key.Key_6, ALT)
    title = "Looking for parts to label"
    qtbot.waitUntil(lambda: line(title) is not None)
    line(title).cancel()
    search = hands.controller.labelling._keys.suggesting
    qtbot.waitUntil(lambda: search._job is None)
    assert "looks again" in search._doing()


def test_what_is_scored_in_a_moment_never_shows_in_the_list(hands, window, press, qtbot):
    seen = []
    window.work.jobs.changed.connect(lambda: seen.extend(window.work.jobs.lines))
    hands.press(Key.Key_S, SHIFT)
    panel = window.workspace.of(ScorePanel)
    qtbot.waitUntil(lambda: panel.table.isVisible() and panel.table.item(0, 0) is not None)
    assert "Scoring" not in [one.title for one in seen]


def window_module(name):
    """The module that does the work of a panel."""
    from app.features.counting import controller as counting
    from app.features.scoring import controller as scoring

    return {"counting": counting, "scoring": scoring}[name]


def texts(panel):
    """All that labels of a panel say."""
    from PySide6.QtWidgets import QLabel

    return [label.text() for label in panel.findChildren(QLabel) if label.isVisible()]
