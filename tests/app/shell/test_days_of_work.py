"""A day's work of an operator and of an annotator, by keys and by mouse.

Also with CVAT's keys and in Japanese; `test_days_at_200_percent.py` has them at 200 %.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import cv2
import numpy as np
import pytest
from correcting_window import CROWDED
from fitting import beyond, cut_off
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from worker import Worker

from app.core.widgets.user_settings import UserSettings
from app.features.files.export_dialog import ExportDialog
from app.features.keys.scene import OwnKeys
from app.shell.application import start_application
from app.shell.main_window import MainWindow
from tracking.formats import read_mot
from tracking.session import Session
from tracking.tracks import Source
from tracking.translation import language_in_use, use_catalogue

WAYS = ("keys", "mouse", "cvat", "japanese")
FRAMES = 24


@pytest.fixture
def language(
    request: pytest.FixtureRequest, qapp: QApplication, remembered: UserSettings
) -> Iterator[None]:
    """Japanese where the day is in Japanese; all texts are English again afterwards."""
    del qapp
    remembered.set_text("language", "ja" if request.param == "japanese" else "en")
    yield
    remembered.set_text("language", "en")
    start_application(remembered)
    use_catalogue(None)


@pytest.fixture
def worker(
    language: None, request: pytest.FixtureRequest, window: MainWindow, qtbot: QtBot
) -> Worker:
    """Who works in this way, at the scaling that the test runs at."""
    del language
    way = request.node.callspec.params["language"]
    assert window.devicePixelRatioF() == float(os.environ.get("QT_SCALE_FACTOR", "1"))
    assert language_in_use() == ("ja" if way == "japanese" else "")
    with qtbot.waitActive(window):
        window.activateWindow()
    if way == "cvat":
        window.key_choice.use(OwnKeys("cvat"))
    return Worker(window, qtbot, keys=way != "mouse")


in_each_way = pytest.mark.parametrize("language", WAYS, indirect=True)


def _nothing_is_cut_off(one: Worker) -> None:
    one.qtbot.wait(600)
    assert "\n".join((*cut_off(one.window), *beyond(one.window))) == ""


@in_each_way
def test_the_day_of_an_operator(worker: Worker, tiny_session: Path) -> None:
    worker.window.remembered.last_folder("open").note(tiny_session)
    worker.open(tiny_session)
    worker.wait(lambda: not worker.controller.reviewing.busy)
    begun = worker.columns()
    _review(worker)
    _nothing_is_cut_off(worker)
    _correct_a_swap(worker)
    done, kinds = worker.columns(), worker.kinds()
    assert done != begun
    worker.do("edit.undo")
    assert worker.columns() == begun
    worker.do("edit.redo")
    assert worker.columns() == done

    path = tiny_session
    worker.do("file.save")
    worker.wait(lambda: not worker.window.work.busy and not worker.window.files.saving.unsaved)
    worker.do("file.close")
    worker.wait(lambda: worker.window.controller is None)
    with closing(Session.open(path)) as saved:
        columns = {name: each.tobytes() for name, each in saved.tracks.columns().items()}
        assert columns == done
        assert [entry.kind for entry in saved.history] == kinds
        assert sorted(one.decision for one in saved.labels.verdicts.values()) == _DECIDED
    worker.open(path)
    assert (worker.columns(), worker.kinds()) == (done, kinds)
    _nothing_is_cut_off(worker)


_DECIDED = ["dismissed", "right"]


def _review(one: Worker) -> None:
    """The first item is right, the next one is dismissed."""
    for decision in ("right", "dismiss"):
        one.do("review.next")
        assert one.controller.reviewing.current is not None
        one.do(f"review.{decision}")
    assert sorted(one.decision for one in one.session.labels.verdicts.values()) == _DECIDED


def _correct_a_swap(one: Worker) -> None:
    one.go(CROWDED)
    first, second = one.people(CROWDED)[:2]
    one.select(first)
    one.do("tracks.swap")
    one.pick_other(second)
    flow = one.controller.document.flow
    assert flow is not None
    assert one.controller.document.planned is not None
    assert one.controller.document.planned.scene.ready
    before = one.row(first, CROWDED), one.row(second, CROWDED)
    one.apply()
    cut = max(flow.cut, CROWDED)
    if cut == CROWDED:
        assert one.row(first, CROWDED)["left"] == before[1]["left"]
        assert one.row(second, CROWDED)["left"] == before[0]["left"]
    assert one.kinds()[-1] == "swap"


@pytest.fixture
def footage(tmp_path: Path) -> Path:
    """A few seconds of nothing, filmed by one camera."""
    folder = tmp_path / "one-camera"
    folder.mkdir()
    for number in range(FRAMES):
        picture = np.full((192, 256, 3), 40 + number, np.uint8)
        assert cv2.imwrite(str(folder / f"{number:03d}.png"), picture)
    text = 'format = 1\nname = "one camera"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    (folder / "recording.toml").write_text(text)
    return folder


@in_each_way
def test_the_day_of_an_annotator(worker: Worker, footage: Path, tmp_path: Path) -> None:
    worker.window.remembered.last_folder("open").note(footage / "recording.toml")
    worker.window.remembered.last_folder("export").note(tmp_path / "tracks.txt")
    worker.open(footage / "recording.toml")
    worker.draw((20.0, 20.0, 20.0, 60.0))
    worker.go(10)
    worker.do("tracks.accept_ghost")
    tracks = worker.session.tracks
    assert tracks.of_frame(10)["track"].tolist() == [1]
    assert tracks.frames_of_track(1).tolist() == list(range(11))
    assert worker.row(1, 5)["source"] == Source.INTERPOLATED
    worker.do("tracks.propagate")
    worker.apply()
    last = worker.session.tracks.frames_of_track(1).tolist()[-1]
    assert last > 10
    worker.do("tracks.occluded")
    worker.apply()
    worker.do("edit.undo")
    _nothing_is_cut_off(worker)
    rows = read_mot(_export(worker))
    assert rows["frame"].tolist() == list(range(last + 1))
    saved = worker.save_as_proposed()
    worker.do("file.close")
    worker.wait(lambda: worker.window.controller is None)
    worker.open(saved)
    assert worker.session.tracks.frames_of_track(1).tolist() == list(range(last + 1))


def _export(one: Worker) -> Path:
    one.do("file.export")
    dialog = one.window.findChild(ExportDialog)
    assert dialog is not None
    one.accept(dialog)
    asked = one.file_dialog()
    path = Path(asked.selectedFiles()[0])
    one.accept(asked)
    one.wait(lambda: path.exists() and not one.window.work.busy)
    one.leave_popups()  # which gives the keyboard back, as a desktop does
    return path
