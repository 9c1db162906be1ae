"""Painted views tell screen readers what they show and who is selected, once they are at rest."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QWidget

from app.core.widgets.spoken_description import SpokenDescription
from app.features.pictures.overhead_view import OverheadView
from app.features.pictures.picture_view import PictureView
from app.features.timeline.overview import OverviewStrip
from app.features.timeline.tracks_area import TracksArea

_VIEWS = (PictureView, OverheadView, TracksArea, OverviewStrip)


def told_of(window, kind) -> str:
    """What a screen reader is told of the first view of a kind that is seen."""
    view = next(one for one in window.findChildren(kind) if one.isVisible())
    return QAccessible.queryAccessibleInterface(view).text(QAccessible.Text.Description)


@pytest.fixture
def opened(window, qtbot, parted_session):
    window.files.open_path(parted_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    return window


@pytest.mark.parametrize("kind", _VIEWS)
def test_a_view_tells_the_frame_and_who_is_selected(opened, qtbot, kind):
    controller = opened.controller
    track = controller.document.tracks.ids[0]
    controller.editing.rename(track, "Anna")
    first = int(controller.document.session.tracks.frames_of_track(track)[0])
    controller.playback.go(first)
    qtbot.waitUntil(lambda: f"Frame {first}" in told_of(opened, kind))
    if kind is OverviewStrip:
        qtbot.waitUntil(lambda: "Tracked: frames" in told_of(opened, kind))
        return
    assert "Selected" not in told_of(opened, kind)
    controller.editing.pick(track)
    qtbot.waitUntil(lambda: "Selected: " in told_of(opened, kind))
    assert "Anna" in told_of(opened, kind).split("Selected: ")[1]


def test_nothing_is_made_while_frames_follow_each_other(qtbot):
    view, made = QWidget(), []
    qtbot.addWidget(view)
    spoken = SpokenDescription(view, lambda: made.append(1) or f"frame {len(made)}")
    frames = QTimer(interval=20)
    frames.timeout.connect(spoken.changed)
    frames.start()
    qtbot.wait(600)
    assert not made
    frames.stop()
    qtbot.waitUntil(lambda: view.accessibleDescription() == "frame 1")
    qtbot.wait(400)
    assert len(made) == 1
