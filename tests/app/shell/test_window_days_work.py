"""A day's work in the real window, from opening a recording to comparing with a colleague."""

from __future__ import annotations

import shutil
from contextlib import closing
from pathlib import Path

import pytest
from correcting_window import CROWDED, CTRL, LEFT, SHIFT, Hands
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from tracking.editing import plan_swap
from tracking.session import Session
from tracking.tracks import Labels

Key = Qt.Key


def test_a_days_work_is_undone_done_again_saved_reopened_and_compared(
    window: MainWindow, qtbot: QtBot, tiny_recording: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "work"
    shutil.copytree(tiny_recording, folder)
    hands = _open_and_track_live(window, qtbot, folder)
    session = _session(hands)
    begun = _bytes(session)

    _swap_by_keys(hands)
    _swap_by_mouse(hands)
    _split(hands)
    _merge_back(hands)
    _name(hands)
    _label_parts(hands)
    done, labels = _bytes(session), session.labels
    edits = len(session.history)
    assert edits >= 6
    assert done != begun

    for _ in range(edits):
        hands.press(Key.Key_Z, CTRL)
    assert (_bytes(session), session.labels) == (begun, Labels())
    assert session.history.next_undo is None
    for _ in range(edits):
        hands.press(Key.Key_Z, CTRL | SHIFT)
    assert (_bytes(session), session.labels) == (done, labels)

    path = _save_and_close(hands, folder / "day.h5")
    hands = _open_again(window, qtbot, path)
    assert (_bytes(_session(hands)), _session(hands).labels) == (done, labels)
    assert len(_session(hands).history) == edits
    _compare_with_a_colleague(hands, path)


def _open_and_track_live(window: MainWindow, qtbot: QtBot, folder: Path) -> Hands:
    window.files.open_path(folder)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    with qtbot.waitActive(window):
        window.activateWindow()
    assert window.controller is not None
    hands = Hands(window, window.controller, qtbot)
    hands.press(Key.Key_Space)  # the first play tracks
    assert window.controller.live.running
    qtbot.waitUntil(lambda: window.files.session is not None and not window.work.busy)
    window.controller.playback.pause()
    hands.go(CROWDED)
    return hands


def _swap_by_keys(hands: Hands) -> None:
    hands.press(Key.Key_Tab)
    first = hands.controller.document.selection.track
    hands.press(Key.Key_X)
    hands.press(Key.Key_Tab)
    flow = hands.controller.document.flow
    assert flow is not None
    other = flow.other
    before = hands.row(first, flow.cut), hands.row(other, flow.cut)
    hands.press(Key.Key_Return)
    after = hands.row(other, flow.cut), hands.row(first, flow.cut)
    assert [row.get("left") for row in after] == [row.get("left") for row in before]
    hands.press(Key.Key_Escape)
    hands.go(CROWDED)


def _swap_by_mouse(hands: Hands) -> None:
    view, (*_, second, first) = hands.window.workspace, hands.people()
    hands.choose_in_menu(view.overhead, hands.place_on(first), "tracks.swap")
    hands.qtbot.wait(5)
    chips = view.preview.findChildren(QToolButton)
    chip = next(chip for chip in chips if chip.text() == str(second) and chip.isVisible())
    QTest.mouseClick(chip, LEFT)
    edits = len(_session(hands).history)
    QTest.mouseClick(view.preview._confirm, LEFT)
    assert [entry.kind for entry in _session(hands).history][edits:] == ["swap"]
    hands.go(CROWDED)


def _split(hands: Hands) -> None:
    track = hands.people()[0]
    _select(hands, track)
    hands.press(Key.Key_S)
    hands.press(Key.Key_Return)
    assert max(hands.frames(track)) < CROWDED
    assert min(hands.frames(_session(hands).tracks.highest_track)) == CROWDED


def _merge_back(hands: Hands) -> None:
    """The two halves are one again, under the id of the first."""
    hands.go(CROWDED - 1)
    rest = _session(hands).tracks.highest_track
    track = next(
        entry.change.before.stretches[0, 0]
        for entry in reversed(_session(hands).history.entries)
        if entry.kind == "split"
    )
    hands.controller.editing.pick(int(track))
    hands.press(Key.Key_M)
    hands.type(str(rest))
    hands.press(Key.Key_Return)
    hands.press(Key.Key_Return)
    assert rest not in _session(hands).tracks
    assert {CROWDED - 1, CROWDED} <= set(hands.frames(int(track)))
    hands.go(CROWDED)


def _name(hands: Hands) -> None:
    track = hands.people()[0]
    _select(hands, track)
    hands.press(Key.Key_F2)
    hands.type("red coat")
    hands.press(Key.Key_Return)
    assert _session(hands).labels.title(track) == f"{track} red coat"
    hands.window.workspace.left.setFocus()


def _label_parts(hands: Hands) -> None:
    track = hands.people()[0]
    _select(hands, track)
    hands.press(Key.Key_1, Qt.KeyboardModifier.AltModifier)
    hands.press(Key.Key_7)
    hands.press(Key.Key_4)
    hands.press(Key.Key_5)
    said = [label.on_part for label in _session(hands).labels.parts.values()]
    assert sorted(said) == [False, True]
    hands.press(Key.Key_Escape)


def _save_and_close(hands: Hands, path: Path) -> Path:
    hands.window.files.saving.save_to(path)
    hands.qtbot.waitUntil(
        lambda: not hands.window.work.busy and not hands.window.files.saving.unsaved,
    )
    hands.press(Key.Key_W, CTRL)
    hands.qtbot.waitUntil(lambda: hands.window.controller is None)
    return path


def _open_again(window: MainWindow, qtbot: QtBot, path: Path) -> Hands:
    window.files.open_path(path)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    assert window.controller is not None
    return Hands(window, window.controller, qtbot)


def _compare_with_a_colleague(hands: Hands, path: Path) -> None:
    """Who swapped two of them once more: the panel says where."""
    colleagues = path.with_name("colleague.h5")
    shutil.copy(path, colleagues)
    with closing(Session.open(colleagues)) as other:
        a, b = other.tracks.of_frame(CROWDED)["track"].tolist()[:2]
        other.apply(plan_swap(other.tracks, a, b, CROWDED))
        other.save()
    hands.window.files.beside.compare_with(colleagues)
    panel = hands.window.workspace.compare
    hands.qtbot.waitUntil(panel.isVisible)
    assert "kappa" in panel._figures.text()
    assert {(row.frame, row.track) for row in panel._model.rows} >= {(CROWDED, a), (CROWDED, b)}


def _select(hands: Hands, track: int) -> None:
    hands.window.activateWindow()  # which a desktop does by itself when a menu closes
    hands.qtbot.waitUntil(hands.window.isActiveWindow)
    hands.controller.editing.pick(track)
    assert hands.controller.document.selection.track == track


def _session(hands: Hands) -> Session:
    session = hands.controller.document.session
    if session is None:
        pytest.fail("no session is open")
    return session


def _bytes(session: Session) -> dict[str, bytes]:
    return {name: column.tobytes() for name, column in session.tracks.columns().items()}
