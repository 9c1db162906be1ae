"""The failure detector in the real window: trained, its operating point moved, kept, used."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from correcting_window import CROWDED, CTRL, Hands, open_for_correcting
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from app.core.document.detector_choice import DetectorChoice, restore_choice
from app.core.document.document_loader import known_recordings
from app.features.parts.mistake_pictures import Here, Search, crop_surroundings
from app.features.parts.result_dialog import ResultDialog
from app.features.parts.train_dialog import TrainDialog
from app.features.parts.training_result import MistakeItem
from app.features.parts.training_set import build_training_set, source_at
from app.features.runs.track_dialog import TrackDialog
from app.shell.detectors import _labels_here
from tracking.editing import plan_label_part, plan_occluders
from tracking.failure import Mistake, built_in_detector, load_detector, save_detector
from tracking.tracks import Occluder, PartLabel

Key = Qt.Key


@pytest.fixture
def hands(window, qtbot, parted_session):
    return Hands(window, open_for_correcting(window, qtbot, parted_session), qtbot)


@pytest.fixture
def labelled(hands):
    """Every other frame of everybody was labelled as it is."""
    document = hands.controller.document
    document.apply(plan_label_part(document.session.labels, _as_it_is(document)))
    hands.controller.draw()
    return hands


def _as_it_is(document):
    rows = document.session.runs[0].parts
    numbers = (rows[name].tolist() for name in ("frame", "track", "part", "failed"))
    boxes = (rows[name].tolist() for name in ("cx", "cy", "width", "height"))
    for frame, track, part, failed, u, v, w, h in zip(*numbers, *boxes, strict=True):
        if frame % 2 == 0:
            box = (u - w / 2, v - h / 2, w, h)
            yield PartLabel(frame, track, part, box, not failed, "tracker", "somebody")


def _ask(window, qtbot, kind, key=None, modifiers=CTRL):
    QTest.keyClick(window, key, modifiers)
    qtbot.waitUntil(lambda: bool(window.findChildren(kind)))
    return window.findChildren(kind)[-1]


def _train_dialog(window, qtbot):
    dialog = _ask(window, qtbot, TrainDialog, Key.Key_D)
    qtbot.waitUntil(lambda: dialog._job is None)
    return dialog


@pytest.fixture
def result(labelled, window, qtbot):
    """A detector was trained from what is labelled, and its page is open."""
    dialog = _train_dialog(window, qtbot)
    dialog._form.put("search_samples", 100)
    dialog._form.put("folds", 2)
    dialog._train.click()
    assert window.progress.isVisible()
    qtbot.waitUntil(lambda: bool(window.findChildren(ResultDialog)))
    shown = window.findChildren(ResultDialog)[-1]
    qtbot.waitUntil(lambda: shown.mistakes._job is None)
    return shown


def test_too_few_labels_are_told_part_by_part(hands, window, qtbot):
    dialog = _train_dialog(window, qtbot)
    assert "holds no labels" in dialog._told.text()
    assert not dialog._train.isEnabled()
    for cells in dialog._cells:
        assert "10 more on and 10 more off" in cells[4].text()
        assert "2 people or more" in cells[4].text()
    assert dialog._off_list.text()
    dialog.reject()


def test_labels_of_a_session_are_counted_and_can_be_left_out(labelled, window, qtbot):
    dialog = _train_dialog(window, qtbot)
    document = labelled.controller.document
    said = list(_as_it_is(document))
    off = sum(label.part == 0 and not label.on_part for label in said)
    assert dialog._cells[0][2].text() == str(off)
    assert dialog._train.isEnabled()
    dialog._list.item(0).setCheckState(Qt.CheckState.Unchecked)
    assert dialog._cells[0][2].text() == "0"
    assert not dialog._train.isEnabled()
    dialog.reject()


def test_labels_are_learnt_from_as_they_were_when_training_was_asked_for(labelled):
    session, recording = (
        labelled.controller.document.session,
        labelled.controller.document.recording,
    )
    read = _labels_here(session, recording)
    before = len(session.labels.parts)
    labelled.press(Key.Key_Z, CTRL)
    assert len(session.labels.parts) == 0
    assert len(read().samples) == before > 0


def test_labels_of_further_sessions_are_added(labelled, window, qtbot, parted_session, tmp_path):
    window.files.saving.save_to(parted_session)
    qtbot.waitUntil(lambda: not window.work.busy)
    other = tmp_path / "other.h5"
    other.write_bytes(parted_session.read_bytes())
    dialog = _train_dialog(window, qtbot)
    alone = int(dialog._cells[1][1].text())
    dialog.add(other)
    qtbot.waitUntil(lambda: dialog._job is None)
    assert dialog._list.count() == 2
    assert int(dialog._cells[1][1].text()) == 2 * alone
    dialog.add(other)
    assert "listed already" in dialog._told.text()
    assert dialog._told.isVisible()
    dialog.add(tmp_path / "missing.h5")
    qtbot.waitUntil(lambda: dialog._job is None)
    assert "missing.h5" in dialog._told.text()
    assert dialog._list.count() == 2
    dialog.reject()


def test_the_loop_closes_labels_train_a_detector_that_tracking_uses(
    result, labelled, window, qtbot
):
    trained = window.files.detectors.result
    assert trained.detector.origin.recordings == (labelled.controller.document.recording.name,)
    found = [cells[1].text() for cells in result._cells]
    parts = len(trained.scene().figures)
    assert all("%" in text for text in found[:parts])
    # Whether several parts of anybody failed at once is the tracker's business.
    assert all("%" in text or text.startswith("0 ") for text in found[parts:])
    areas = [cells[5].text() for cells in result._cells]
    assert len(areas) == len(trained.trained.report.questions)
    assert all(0.0 <= float(area) <= 1.0 for area in areas[:parts])
    assert all(area == "\u2013" or 0.0 <= float(area) <= 1.0 for area in areas[parts:])
    assert result._warning.isVisible() == bool(trained.scene().warning)
    use = next(
        b
        for b in result.findChildren(type(window.menuBar().cornerWidget()))
        if b.text() == "Use for tracking"
    )
    use.click()
    choice = labelled.controller.document.detector
    assert load_detector(Path(choice.path)).fingerprint == trained.detector.fingerprint
    assert choice.name in result._told.text()
    assert labelled.controller.tracking.propose_tracker == "three-part"
    assert choice.name.startswith("detector trained 20")
    window.run_command("review.again")
    again = window.findChildren(TrackDialog)[-1]
    assert again.answer()[:2][1].detector == choice.path
    again.reject()
    document = labelled.controller.document
    parts = document.parts_asked
    asked = TrackDialog(document.recording, "three-part", window.remembered, "", window, parts)
    name, settings, _, _ = asked.answer()
    assert (name, settings.detector) == ("three-part", choice.path)
    asked._parts._detector.setCurrentIndex(1)
    assert asked.answer()[1].detector == ""
    result.close()
    window.run_command("detector.built_in")
    assert document.detector == DetectorChoice()


def test_the_operating_point_is_dragged_stepped_and_chosen_for_one_part(result, window, tmp_path):
    shown = window.files.detectors.result
    area = result.plot._area()

    def drag(share: float) -> None:
        x = area.left() + share * area.width() / result.plot._most
        QTest.mouseClick(
            result.plot, Qt.MouseButton.LeftButton, pos=QPointF(x, area.center().y()).toPoint()
        )

    drag(0.2)
    loose = shown.scene().figures
    drag(0.0)
    strict = shown.scene().figures
    assert all(one.false_alarms == 0 for one in strict)
    assert all(a.found <= b.found for a, b in zip(strict, loose, strict=True))
    result.plot.setFocus()
    QTest.keyClick(result.plot, Key.Key_Right)
    assert [one.false_alarms for one in shown.scene().figures] == [1, 1, 1]
    result.part_choice.setCurrentIndex(2)
    QTest.keyClick(result.plot, Key.Key_Right)
    assert [one.false_alarms for one in shown.scene().figures] == [1, 2, 1]
    assert result._cells[1][3].text().startswith("2  (")
    path = tmp_path / "mine.h5"
    window.files.detectors.save_to(path)
    assert np.array_equal(load_detector(path).thresholds, shown.detector.thresholds)


def test_a_mistake_is_a_small_picture_that_takes_one_to_its_frame(result, labelled, window, qtbot):
    shown = window.files.detectors.result
    for _ in range(3):
        shown.step(1)  # a few false alarms, so that there is something to look at
    result._show()
    items = result.mistakes._items
    assert items
    qtbot.waitUntil(lambda: result.mistakes._job is None)
    piece, box = result.mistakes._pictures[items[0]]
    assert piece.shape[2] == 3
    assert 0 < box[2] < piece.shape[1]
    result.mistakes.itemClicked.emit(result.mistakes.item(0))
    controller = labelled.controller
    assert controller.playback.clock.frame == items[0].frame
    assert controller.document.selection.track == items[0].track
    assert controller.labelling.part == items[0].part


def test_a_mistake_of_another_session_is_a_picture_of_its_recording(
    labelled, window, qtbot, parted_session
):
    window.files.saving.save_to(parted_session)
    qtbot.waitUntil(lambda: not window.work.busy)
    training_set = build_training_set([source_at(parted_session)])
    number = int(np.flatnonzero(training_set.samples.columns["frame"] == CROWDED)[0])
    row = {name: column[number] for name, column in training_set.samples.columns.items()}
    where = (int(row["track"]), int(row["frame"]))
    wrong = Mistake(number, int(row["part"]), "", *where, bool(row["label"]), 1.0)
    source = training_set.sources[0]
    item = MistakeItem(source, source.recording, wrong, training_set.box_of(number), "", "", "")
    document, search = labelled.controller.document, Search(known_recordings())
    here = Here.of(document.recording, document.session)
    from_closed = crop_surroundings(None, search, [item], lambda *_: None)[item]
    from_open = crop_surroundings(here, search, [item], lambda *_: None)[item]
    table = replace(source, path=source.path.with_suffix(".csv"), fps=0.0, boxes=None)
    untold = replace(item, source=table, box=None)
    of_table = crop_surroundings(here, search, [untold], lambda *_: None)[untold]
    assert np.array_equal(from_closed[0], from_open[0])
    assert from_closed[1] == from_open[1] == pytest.approx(of_table[1], abs=1e-3)
    gone = replace(training_set.sources[0], path=parted_session.with_name("gone.h5"))
    missing = replace(item, source=gone)
    assert crop_surroundings(None, search, [missing], lambda *_: None) == {missing: None}


@pytest.mark.parametrize("warning", ["", "No better than chance: head."])
def test_use_for_tracking_is_proposed_only_where_nothing_is_warned_of(
    result, window, monkeypatch, warning
):
    scene = replace(result.result_shown.scene(), warning=warning)
    monkeypatch.setattr(result.result_shown, "scene", lambda: scene)
    again = ResultDialog(result.result_shown, lambda items, _: dict.fromkeys(items), window)
    (proposed,) = [one for one in again.findChildren(QPushButton) if one.isDefault()]
    assert proposed.text() == ("Close" if warning else "Use for tracking")
    again.done(0)


def test_training_is_cancelled_and_nothing_is_kept(labelled, window, qtbot):
    dialog = _train_dialog(window, qtbot)
    dialog._train.click()
    window.progress.cancelled.emit()
    qtbot.waitUntil(lambda: not window.work.busy)
    assert window.files.detectors.result is None
    assert "Stopped" in window.statusBar().currentMessage()
    assert not window.findChildren(ResultDialog)


def test_after_a_cancelled_training_the_same_sessions_are_proposed_again(
    labelled, window, qtbot, parted_session, tmp_path
):
    window.files.saving.save_to(parted_session)
    qtbot.waitUntil(lambda: not window.work.busy)
    other = tmp_path / "other.h5"
    other.write_bytes(parted_session.read_bytes())
    dialog = _train_dialog(window, qtbot)
    dialog.add(other)
    qtbot.waitUntil(lambda: dialog._job is None)
    counted = dialog._cells[1][1].text()
    dialog._train.click()
    window.progress.cancelled.emit()
    qtbot.waitUntil(lambda: not window.work.busy)
    window.files.detectors.ask_train()
    again = window.findChildren(TrainDialog)[-1]
    assert again is not dialog
    qtbot.waitUntil(lambda: again._job is None)
    assert again._list.count() == 2
    assert again._cells[1][1].text() == counted
    assert again._train.isEnabled()
    again.reject()


def test_a_trained_detector_in_use_goes_by_the_name_it_is_saved_under(
    result, window, qtbot, tmp_path
):
    detectors, path = window.files.detectors, tmp_path / "mine.h5"
    detectors.use_trained()
    assert detectors.choice.name.startswith("detector trained")
    detectors.save_to(path)
    assert detectors.choice == DetectorChoice(str(path))
    assert "Saved" in window.statusBar().currentMessage()
    detectors.use_built_in()
    detectors.use_trained()
    assert detectors.choice == DetectorChoice(str(path))


def test_the_menu_shows_which_detector_is_in_use(hands, window, qtbot, tmp_path):
    from_file = window.menus.actions["detector.open"]
    built_in = window.menus.actions["detector.built_in"]
    window.bring_up_to_date()
    assert built_in.isChecked()
    assert not from_file.isChecked()
    path = tmp_path / "mine & yours.h5"
    save_detector(path, built_in_detector())
    window.files.detectors.use_file(path)
    qtbot.waitUntil(lambda: hands.controller.document.detector.path == str(path))
    window.bring_up_to_date()
    assert not built_in.isChecked()
    assert from_file.isChecked()
    assert from_file.text() == "Use a part-failure detector from a file... (mine && yours.h5)"
    window.run_command("detector.built_in")
    window.bring_up_to_date()
    assert from_file.text() == "Use a part-failure detector from a file..."


def test_a_file_that_is_no_detector_is_refused_and_the_one_in_use_stays(
    hands, window, qtbot, tmp_path
):
    path = tmp_path / "text.h5"
    path.write_text("nothing")
    window.files.detectors.use_file(path)
    qtbot.waitUntil(lambda: not window.work.busy)
    assert window.notice.isVisible()
    assert hands.controller.document.detector == DetectorChoice()


def test_a_detector_from_a_file_is_used_and_remembered(hands, window, qtbot, tmp_path):
    path = tmp_path / "mine.h5"
    save_detector(path, built_in_detector())
    window.files.detectors.use_file(path)
    qtbot.waitUntil(lambda: hands.controller.document.detector.path == str(path))
    checked = {item.command: item.checked for item in window.registry.items()}
    assert checked["detector.built_in"] is False
    assert restore_choice(window.remembered.text("detector")) == DetectorChoice(str(path))
    path.unlink()
    assert restore_choice(window.remembered.text("detector")) == DetectorChoice()


def test_occluders_that_are_drawn_are_handed_to_trackers_of_parts(hands, window, qtbot):
    document = hands.controller.document
    pillar = Occluder("pillar", ((10.0, 20.0), (40.0, 20.0), (40.0, 200.0)))
    document.apply(plan_occluders(document.session.labels, (pillar,)))
    dialog = _ask(window, qtbot, TrackDialog, Key.Key_T)
    names = dialog._names
    dialog._choice.setCurrentIndex(names.index("three-part"))
    assert dialog._parts.isVisibleTo(dialog)
    assert "1 drawn" in dialog._parts._occluders.text()
    assert dialog.answer()[1].occluders == "[[[10.0, 20.0], [40.0, 20.0], [40.0, 200.0]]]"
    dialog._choice.setCurrentIndex(names.index("stereo-direction"))
    assert not dialog._parts.isVisibleTo(dialog)
    dialog.reject()


def test_parts_are_labelled_from_rendered_truth_as_one_edit(hands, window, qtbot):
    document = hands.controller.document
    window.run_command("detector.truth")
    qtbot.waitUntil(lambda: not window.work.busy)
    labels = document.session.labels.parts
    assert len(labels) > 0
    assert {label.source for label in labels.values()} == {"truth"}
    hands.press(Key.Key_Z, CTRL)
    assert len(document.session.labels.parts) == 0
