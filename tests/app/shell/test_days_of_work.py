"""A day's work of an operator, an annotator and an engineer, by keys and by mouse.

Also with CVAT's keys and in Japanese; `test_days_at_200_percent.py` has them at 200 %.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from correcting_window import CROWDED
from fitting import beyond, cut_off
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shifted_runs import swapped
from worker import Worker

from app.core.document import document_loader
from app.core.widgets.user_settings import UserSettings
from app.features.correction.schema_dialog import SchemaDialog
from app.features.files.export_dialog import ExportDialog
from app.features.keys.scene import OwnKeys
from app.features.runs.runs_dialog import RunsDialog
from app.features.scoring.controller import ScoreController
from app.features.scoring.panel import ScorePanel
from app.shell.application import start_application
from app.shell.main_window import MainWindow
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring import FloorMatch
from tracking.session import Session
from tracking.tracks import Attribute, AttributeType, Run, Source
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


@pytest.fixture
def two_runs(tiny_recording: Path, tiny_run: Run, tmp_path: Path) -> Path:
    """A session of two runs; in the one that is corrected two people have each other's id."""
    path = tmp_path / "two-runs.h5"
    with open_recording(tiny_recording) as recording:
        runs = [replace(tiny_run, seed=7), swapped(tiny_run)[0]]
        session = Session.create(recording, runs, path)
        document_loader.remember_place(session, recording)
        session.close()
    return path


@in_each_way
def test_the_day_of_an_engineer(worker: Worker, two_runs: Path, tmp_path: Path) -> None:
    worker.window.remembered.last_folder("open").note(two_runs)
    worker.open(two_runs)
    assert worker.session.adopted_run == 1
    _compare_the_runs(worker)
    _correct_the_first_run(worker)
    _score_on_the_floor(worker)
    reports = tmp_path / "reports"
    reports.mkdir()
    worker.window.remembered.last_folder("report").note(reports)
    _nothing_is_cut_off(worker)
    _report(worker, reports)
    worker.do("file.save")
    worker.wait(lambda: not worker.window.work.busy and not worker.window.files.saving.unsaved)
    worker.do("file.close")
    worker.wait(lambda: worker.window.controller is None)
    with closing(Session.open(two_runs)) as session:
        assert (session.adopted_run, session.corrected_run.seed) == (0, 7)
        _report_tells_of(session, reports)


def _compare_the_runs(one: Worker) -> None:
    dialog = _runs(one)
    one.choose_rows(dialog._table, 1, 2)
    assert dialog.chosen == [0, 1]
    one.push(dialog._compare)
    one.wait(lambda: bool(one.controller.document.comparison.scene().items))
    comparison, panel = one.controller.document.comparison, one.window.workspace.differences
    assert {comparison.base, comparison.run} == {0, 1}
    _nothing_is_cut_off(one)
    one.push(panel._close, panel)
    assert not one.controller.comparing.shown


def _correct_the_first_run(one: Worker) -> None:
    dialog = _runs(one)
    one.choose_rows(dialog._table, 1, 1)
    one.push(dialog._correct)
    one.wait(lambda: one.session.adopted_run == 0)


def _runs(one: Worker) -> RunsDialog:
    """The list of runs, once all are scored."""
    one.do("tracks.runs")
    dialog = one.dialog()
    assert isinstance(dialog, RunsDialog)
    one.wait(lambda: all(dialog._table.item(row, 6).text() for row in (1, 2)))
    assert "\n".join(cut_off(dialog)) == ""
    return dialog


RADIUS_M = 0.8


def _score_on_the_floor(one: Worker) -> None:
    """People match up to a distance of the engineer's own."""
    one.do("view.score")
    scoring, panel = one.controller.of(ScoreController), one.window.workspace.of(ScorePanel)
    one.wait(lambda: scoring.known)
    one.choose_from(panel._way, 1, panel)
    one.fill(panel._threshold, str(RADIUS_M), panel)
    one.press("Return")

    def scored() -> bool:
        last = scoring.presenter.scored
        return last is not None and last.subject.matching.match == FloorMatch(RADIUS_M)

    one.wait(scored)


def _report(one: Worker, place: Path) -> None:
    one.do("file.export_report")
    one.answer_file(place)
    one.wait(lambda: bool(one.window.notice.text) and not one.window.work.busy)
    one.leave_popups()


def _report_tells_of(session: Session, reports: Path) -> None:
    """The corrected tracks are those of the run that was chosen, scored as was asked."""
    (folder,) = reports.iterdir()
    assert (folder / "report.html").exists()
    told = json.loads((folder / "report.json").read_text())
    assert (told["match"], told["radius_m"]) == ("floor", RADIUS_M)
    figures = {name: one["combined"] for name, one in told["results"].items()}
    corrected, chosen, other = figures.values()
    assert len(session.runs) == 2
    assert corrected == chosen
    for figure in ("HOTA", "IDF1"):
        assert corrected[figure] > other[figure]
    rows = len(session.tracks.columns()["frame"])
    assert corrected["result_rows"] == corrected["matches"] + corrected["false_positives"] <= rows
    assert 0 < corrected["position_error_m"]["p95"] < RADIUS_M
