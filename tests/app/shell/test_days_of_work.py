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
from app.features.correction.schema_dialog import SchemaDialog
from app.features.files.export_dialog import ExportDialog
from app.features.keys.scene import OwnKeys
from app.shell.application import start_application
from app.shell.main_window import MainWindow
from tracking.formats import read_mot
from tracking.session import Session
from tracking.tracks import Attribute, AttributeType, Source
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
    """A few seconds of one camera, in which a detector saw somebody walk to the right."""
    folder = tmp_path / "one-camera"
    folder.mkdir()
    for number in range(FRAMES):
        picture = np.full((192, 256, 3), 40 + number, np.uint8)
        assert cv2.imwrite(str(folder / f"{number:03d}.png"), picture)
    seen = (f"{frame + 1},-1,{5 + 4 * frame},11,20,60,0.9,-1,-1,-1\n" for frame in range(FRAMES))
    (folder / "det.txt").write_text("".join(seen))
    text = 'format = 1\nname = "one camera"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    (folder / "recording.toml").write_text(text)
    return folder


WALKS, STANDS = (4.0, 10.0, 20.0, 60.0), (140.0, 100.0, 20.0, 60.0)
"""Boxes of the two people in the first frame."""


@in_each_way
def test_the_day_of_an_annotator(worker: Worker, footage: Path, tmp_path: Path) -> None:
    worker.window.remembered.last_folder("open").note(footage / "recording.toml")
    worker.window.remembered.last_folder("export").note(tmp_path / "tracks.txt")
    worker.open(footage / "recording.toml")
    _draw_two_people(worker)
    last = _copy_onto_the_next_frames(worker)
    _describe(worker)
    _label_parts(worker)
    _nothing_is_cut_off(worker)
    rows = read_mot(_export(worker))
    assert rows["frame"][rows["track"] == 1].tolist() == list(range(5))
    assert rows["frame"][rows["track"] == 2].tolist() == list(range(last + 1))
    saved = worker.save_as_proposed()
    worker.do("file.close")
    worker.wait(lambda: worker.window.controller is None)
    with closing(Session.open(saved)) as session:
        _tracks_are_as_drawn(session, last)
        _labels_are_as_said(session)
    worker.open(saved)
    assert worker.session.tracks.frames_of_track(2).tolist() == list(range(last + 1))


def _draw_two_people(one: Worker) -> None:
    """One goes on where a detector saw them, the other where they stood."""
    one.draw(WALKS)
    one.draw(STANDS)
    one.do("view.suggestions")
    one.select(1)
    one.go(4)
    one.wait(lambda: any(not mark.ghost for mark in one.window.workspace.left._suggested))
    one.do("tracks.accept_suggestion")
    one.do("view.suggestions")
    one.go(0)
    one.select(2)
    one.go(10)
    one.do("tracks.accept_ghost")


def _copy_onto_the_next_frames(one: Worker) -> int:
    """Up to which frame; a mark that was wrong is taken back."""
    one.do("tracks.propagate")
    one.apply()
    last: int = one.session.tracks.frames_of_track(2).tolist()[-1]
    assert last > 10
    one.do("tracks.occluded")
    one.apply()
    one.do("edit.undo")
    return last


def _describe(one: Worker) -> None:
    """A schema is written, then digit keys say who is what."""
    one.do("tracks.schema")
    dialog = one.window.findChild(SchemaDialog)
    assert dialog is not None
    one.push(dialog.add)
    one.fill(dialog.name, "role")
    one.choose_from(dialog.type, dialog.type.findData(AttributeType.CHOICE))
    one.to(dialog.choices)
    one.type("guest")
    one.press("Return")
    one.type("staff")
    one.push(dialog.ok)
    one.leave_popups()
    one.do("tracks.next_attribute")
    for track, option in ((2, 2), (1, 1)):
        one.go(2)
        one.select(track)
        one.choose_option(option)
    one.do("tracks.next_attribute")


def _label_parts(one: Worker) -> None:
    """The head is on, the torso is off."""
    one.do("labels.parts")
    one.do("labels.head")
    one.do("labels.on")
    one.do("labels.off")
    one.do("labels.parts")


def _tracks_are_as_drawn(session: Session, last: int) -> None:
    tracks = session.tracks
    assert tracks.frames_of_track(1).tolist() == list(range(5))
    assert tracks.frames_of_track(2).tolist() == list(range(last + 1))
    assert _box(session, 1, 0) == pytest.approx(WALKS, abs=3)
    assert _box(session, 1, 4) == pytest.approx((20.0, 10.0, 20.0, 60.0))  # as it was detected
    assert _box(session, 2, 0) == pytest.approx(STANDS, abs=3)
    assert _box(session, 2, last) == _box(session, 2, 0)
    for track, frame in ((1, 2), (2, 5)):
        rows = tracks.of_track(track, frame, frame + 1)
        assert rows["source"].tolist() == [Source.INTERPOLATED]
    assert (tracks.of_track(2)["visibility"] == 1.0).all()


def _box(session: Session, track: int, frame: int) -> tuple[float, ...]:
    row = session.tracks.of_track(track, frame, frame + 1)
    return tuple(row[side].item() for side in ("left", "top", "width", "height"))


def _labels_are_as_said(session: Session) -> None:
    labels = session.labels
    assert labels.schema == (Attribute("role", AttributeType.CHOICE, ("guest", "staff")),)
    said = {track: dict(labels.of_track(track).attributes) for track in (1, 2)}
    assert said == {1: {"role": "guest"}, 2: {"role": "staff"}}
    parts = {(one.track, one.part): one.on_part for one in labels.parts.values()}
    assert parts == {(1, 0): True, (1, 1): False}


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
