"""What a session says of its review is the same when it is opened again, and everywhere."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.cli import review as review_command
from app.core.editing import edits
from app.core.scenes.review_words import risk_text
from tests.project.projects import read_all
from tracking.project import Project

Key = Qt.Key


def _open(window, qtbot, path):
    window.files.open_path(path)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    with qtbot.waitActive(window):
        window.activateWindow()
    reviewing = window.controller.reviewing
    qtbot.waitUntil(lambda: reviewing.queue.is_searched and not reviewing.busy)
    return window.controller


@pytest.fixture
def press(window, qtbot):
    def press(*keys) -> None:
        for key in keys:
            qtbot.wait(1)  # commands are enabled before the next event
            QTest.keyClick(window.focusWidget() or window, key)
            qtbot.wait(1)

    return press


def _review(window, qtbot, press, path):
    """A sitting: one item is corrected by hand, and one is said to be right."""
    controller = _open(window, qtbot, path)
    reviewing = controller.reviewing
    asked = next(one for one in reviewing.queue.open if one.fix == "swap")
    reviewing.go_to(asked.key)
    controller.editing.begin(edits.SWAP)
    controller.playback.go(asked.frame)
    controller.editing.put_cut(asked.frame)
    controller.editing.confirm()
    qtbot.waitUntil(lambda: not reviewing.busy)
    press(Key.Key_N, Key.Key_Z)
    return controller


def test_opened_again_the_list_and_all_figures_are_the_same_everywhere(
    window, qtbot, press, swapped_session, monkeypatch
):
    path = swapped_session[0]
    controller = _review(window, qtbot, press, path)
    state, rows = controller.reviewing.queue.state, controller.reviewing.queue.items
    assert (state.decided, state.outcome.errors) == (2, 1)
    said = window.workspace.review._meter.text().splitlines()[0]
    controller.document.session.save()
    window.files.close_without_asking()

    queue = _open(window, qtbot, path).reviewing.queue
    assert queue.state == state
    assert [row.key for row in queue.items] == [row.key for row in rows]
    assert [row.likelihood for row in queue.items] == [row.likelihood for row in rows]
    assert window.workspace.review._meter.text() == said
    assert risk_text(state.errors) in said
    window.files.close_without_asking()

    printed = []
    monkeypatch.setattr(review_command, "print_json", printed.append)
    review_command.run_review(path, "worth", None, as_json=True)
    (told,) = printed
    assert told["errors_left"]["expected"] == state.errors.mean
    assert (told["decided"], told["open"]) == (state.decided, len(state.left))
    assert [one["frame"] for one in told["review_items"]] == [row.key[2] for row in rows]

    project = Project(path.parent, path.parent / "cache")
    found, _ = read_all(project)
    project.close()
    (facts,) = [one.facts for row in found.rows for one in row.sessions if one.path == path]
    assert facts.errors == state.errors
    assert (facts.decided, facts.items_left) == (state.decided, len(state.left))
    assert facts.reviewed_rows == state.reviewed
