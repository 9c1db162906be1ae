"""The window shows both pictures of an instant where a camera is late."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from patient import PATIENCE_S
from PySide6.QtCore import QObject

from app.core.document.document import Document
from app.core.playback.frames import FrameReader
from app.core.scenes import Side
from app.core.tracks.frame_state import Kinds, ViewOptions
from app.features.pictures.overlay_maker import OverlayMaker
from app.features.pictures.presenter import PicturePresenter
from tests.benchmarks.stereo.troubles import Trouble, troubled
from tracking.recording import Instants, Recording, StereoFrame, open_recording
from tracking.session import Session

LAG = 6


@pytest.fixture(scope="module")
def late_recording(tiny_recording: Path) -> Path:
    return troubled(tiny_recording, Trouble("late", lag=LAG))


@pytest.fixture
def recording(no_threads_left: None, late_recording: Path) -> Iterator[Recording]:
    with open_recording(late_recording) as opened:
        yield opened


@pytest.fixture
def reader(recording: Recording) -> Iterator[FrameReader]:
    """Ended however a test ends: a thread that is left may keep the whole run from ending."""
    owner = QObject()
    made = FrameReader(recording, 50_000_000, owner)
    yield made
    made.close()


def test_a_frame_comes_again_with_its_partner_once_the_lag_is_found(reader, recording, qtbot):
    shown = []
    reader.ready.connect(lambda ticket, frame: shown.append((ticket, frame)))
    ticket = reader.request(20)
    qtbot.waitUntil(lambda: len(shown) == 2)
    qtbot.waitUntil(lambda: reader.get_cached(24) is not None)
    ahead = reader.get_cached(24)
    partner = recording.read(20 + LAG)
    (_, raw), (again, paired) = shown
    assert (ticket, raw.right_lag) == (again, 0)
    assert (paired.number, paired.right_lag, ahead.right_lag) == (20, LAG, LAG)
    assert np.array_equal(paired.right, partner.right)
    assert np.array_equal(paired.left, raw.left)


def test_a_lag_that_the_recording_tells_is_shown_from_the_first_frame(recording, request, qtbot):
    recording.right_lag = LAG
    reader = request.getfixturevalue("reader")
    with qtbot.waitSignal(reader.ready) as answer:
        reader.request(20)
    assert answer.args[1].right_lag == LAG


def test_the_threads_of_a_reader_end_with_it_though_nobody_closed_it(recording):
    before = set(threading.enumerate())
    owner = QObject()
    FrameReader(recording, 50_000_000, owner).request(20)
    assert set(threading.enumerate()) > before
    del owner
    while begun := set(threading.enumerate()) - before:
        thread = begun.pop()
        thread.join(PATIENCE_S)
        assert not thread.is_alive()


def test_the_right_picture_says_which_frame_it_is(recording, tiny_session):
    document, pictures = (
        Document(recording, Session.open(tiny_session)),
        PicturePresenter(recording),
    )
    instants, said = Instants(recording, LAG), []
    for number in (20, recording.frame_count - 1):
        state = document.frame_state(number)
        frame = instants.read(number)
        cameras = (Side.LEFT, Side.RIGHT)
        scenes = [pictures.scene(e, frame, state, ViewOptions()) for e in cameras]
        said.append([scene.message for scene in scenes])
    document.session.close()
    assert said[0] == ["", "Frame 26 of this camera: the same instant"]
    assert said[1] == ["", "Nothing was recorded at this instant: another frame is shown"]


@pytest.fixture
def maker(no_threads_left: None) -> Iterator[OverlayMaker]:
    """Paints by how much the right camera was late; ended however a test ends."""

    def paint(frame: StereoFrame, _kinds: Kinds) -> np.ndarray:
        return np.full((2, 2, 4), frame.right_lag, np.uint8)

    owner = QObject()
    made = OverlayMaker(paint, lambda _: None, 1000, owner)
    yield made
    made.close()


def test_overlays_of_pictures_that_were_paired_wrongly_are_forgotten(maker, qtbot):
    kinds, picture = Kinds(foreground=True), np.zeros((2, 2, 3), np.uint8)
    for lag in (0, LAG):
        with qtbot.waitSignal(maker.ready):
            maker.request(StereoFrame(3, 0.0, picture, picture, lag), kinds)
        assert (maker.get(3, kinds) == lag).all()
