"""Scoring the tiny session against its truth, without a window."""

import json
from dataclasses import replace

import numpy as np
import pytest
from two_people import steps

from app.__main__ import run
from app.cli.score_inputs import true_table
from app.cli.tracks import truth_at
from app.core.document.document import Document
from app.core.scenes import Side
from app.core.scenes.ground_truth import ErrorsOf
from app.features.comparison.presenter import Comparison
from app.features.scoring.presenter import ScoringPresenter
from app.features.scoring.subject import score_subject
from app.features.scoring.truths import TruthKind, TruthSource
from tracking.editing import plan_delete
from tracking.errors import FormatError, SessionError
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring import ErrorKind, ScoringTable, errors, score
from tracking.session import Session


@pytest.fixture
def document(tiny_recording, tiny_session):
    with open_recording(tiny_recording) as recording:
        document = Document(recording, Session.open(tiny_session))
        yield document
        document.session.close()


@pytest.fixture
def presenter(document):
    return ScoringPresenter(document)


def score_now(presenter):
    subject = presenter.current_subject()
    scored = score_subject(subject, presenter.scored, presenter.capture(subject), lambda *_: None)
    presenter.take(scored)
    return scored


def figures(score):
    """All but what needs confidences, which the window does not ask for."""
    return {name: value for name, value in score.as_json().items() if name != "track_map"}


def cell(presenter, name: str, column: str) -> str:
    return next(getattr(row, column) for row in presenter.scene("").rows if row.name == name)


def test_the_figures_are_those_of_the_scorer(presenter, document, tiny_recording):
    scored = score_now(presenter)
    truth = ScoringTable.from_columns(read_mot(tiny_recording / "truth.txt"), dont_cares=True)
    result = ScoringTable.from_columns(document.session.tracks.columns())
    assert figures(scored.whole) == figures(score(truth, result, frames=scored.whole.frames))
    assert cell(presenter, "MOTA", "whole") == f"{scored.whole.clear.mota:.3f}"
    assert len(scored.errors) == len(errors(truth, result))


def test_the_frames_shown_are_scored_as_if_there_were_no_others(presenter, document):
    score_now(presenter)
    presenter.visible = (40, 60)
    scored = score_now(presenter)
    truth = scored.truth.table.within(40, 60)
    result = ScoringTable.from_columns(document.session.tracks.columns()).within(40, 60)
    assert figures(scored.visible) == figures(score(truth, result, frames=20))
    assert scored.whole.frames == document.recording.frame_count


def test_only_the_frames_that_were_tracked_are_scored(presenter, document):
    run = document.session.runs[0]
    early = {name: column[run.tracks["frame"] < 50] for name, column in run.tracks.items()}
    document.session.add_run(replace(run, frames=(0, 50), tracks=early))
    presenter.choice.track_source = 1
    scored = score_now(presenter)
    assert scored.whole.frames == 50
    assert scored.errors.frame.max(initial=0) < 50


def test_the_frames_of_errors_are_those_of_the_recording(presenter, document):
    run = document.session.runs[0]
    late = {name: column[run.tracks["frame"] >= 50] for name, column in run.tracks.items()}
    frames = (50, document.recording.frame_count)
    document.session.add_run(replace(run, frames=frames, tracks=late))
    presenter.choice.track_source = 1
    scored = score_now(presenter)
    assert scored.errors.frame.min(initial=50) >= 50
    misses = scored.errors.of_kind(ErrorKind.MISS)
    known = {(int(f), int(t)) for f, t in zip(*_rows(scored.truth.table), strict=True)}
    assert {(int(f), int(t)) for f, t in zip(misses.frame, misses.truth, strict=True)} <= known


def _rows(table):
    return table.frame, table.track


def test_an_edit_moves_the_score_and_undoing_it_moves_it_back(presenter, document):
    before = score_now(presenter).whole.clear.misses
    longest = max(document.tracks.ids, key=lambda one: len(document.tracks.of_track(one)["frame"]))
    document.apply(plan_delete(document.session.tracks, longest))
    after = score_now(presenter).whole.clear.misses
    assert after > before
    row = next(row for row in presenter.scene("").rows if row.name == "Misses")
    assert row.moved == f"\u25b2 +{after - before}"
    assert row.better == -1
    edit = document.session.history.entries[-1].id
    told = presenter.annotate_edits(document.history())
    assert [item.moved[:6] for item in told if item.edit == edit] == ["HOTA \u25bc"]
    document.undo()
    score_now(presenter)
    assert presenter.scene("").moved.startswith("Undone: ")
    row = next(row for row in presenter.scene("").rows if row.name == "Misses")
    assert (row.moved, row.better) == (f"\u25bc \u2212{after - before}", 1)


def test_another_run_can_be_the_truth(presenter, document):
    presenter.choice.source = TruthSource(TruthKind.RUN, run=0)
    scored = score_now(presenter)
    assert scored.whole.clear.mota == 1.0
    assert len(scored.errors) == 0
    assert "Run 0" in presenter.scene("").truths[presenter.scene("").truth]


def test_bad_rows_of_a_truth_are_told_and_the_others_taken(presenter, tiny_recording, tmp_path):
    lines = (tiny_recording / "truth.txt").read_text().splitlines()
    bad = tmp_path / "other.txt"
    bad.write_text("\n".join(["5,-3,1,1,1,1,1,1,1,1", *lines]))
    presenter.choose_file(bad)
    scored = score_now(presenter)
    assert "1 row is left out: line 1" in scored.truth.notes[0]
    assert len(scored.truth.table) == len(lines)


def test_what_is_no_truth_is_refused(presenter, document, tmp_path):
    with pytest.raises(SessionError, match="open session itself"):
        presenter.choose_file(document.session.path)
    noise = tmp_path / "noise.txt"
    noise.write_bytes(bytes(range(256)))
    presenter.choose_file(noise)
    with pytest.raises(FormatError):
        score_now(presenter)


def test_an_empty_truth_is_scored_and_told_as_on_the_command_line(
    presenter, document, tiny_session, tmp_path, capsys
):
    truth = tmp_path / "nobody.txt"
    for emptied in ("", " \n\n"):
        truth.write_text(emptied)
        assert run(["score", str(tiny_session), "--truth", str(truth), "--json"]) == 0
        out, err = capsys.readouterr()
        presenter.choose_file(truth)
        for on_floor in (False, True):
            presenter.choose_floor(on_floor)
            scored = score_now(presenter)
            rows = len(document.session.tracks.columns()["frame"])
            assert scored.errors.count(ErrorKind.FALSE_ALARM) == len(scored.errors) == rows
            assert scored.whole.clear.false_positives == json.loads(out)["false_positives"] == rows
            (note,) = presenter.scene("").notes
            assert note.startswith("nobody.txt has nobody in these frames: everybody")
            assert f"{tmp_path / note}" in err


def test_people_who_are_missed_are_marked_on_picture_and_floor(presenter, document):
    scored = score_now(presenter)
    misses = scored.errors.of_kind(ErrorKind.MISS)
    frame, who = int(misses.frame[0]), int(misses.truth[0])
    state = document.frame_state(frame)
    picture = presenter.people.picture(Side.LEFT, state)
    floor = presenter.people.floor(state)
    for people in (picture.people, floor.people):
        assert {one.label for one in people if one.wrong is ErrorKind.MISS} == {f"T{who}"}
    assert [entry.text for entry in picture.legend] == [
        "ground truth: T and its number",
        "missed",
        "false alarm",
    ]


def test_a_kind_that_is_left_out_is_neither_shown_nor_walked(presenter):
    scored = score_now(presenter)
    presenter.show_kind(ErrorKind.MISS, False)
    assert ErrorKind.MISS not in [lane.kind for lane in presenter.lanes().lanes]
    assert not np.isin(presenter.events.kind, [ErrorKind.MISS]).any()
    assert len(presenter.events) < len(scored.events)


def test_lanes_stay_the_same_while_the_errors_do(presenter):
    score_now(presenter)
    before = presenter.lanes()
    presenter.visible = (10, 20)
    score_now(presenter)
    assert presenter.lanes() is before
    for lane in before.lanes:
        assert int(lane.density.sum()) == lane.count


def test_while_a_tracker_is_at_work_whole_seconds_of_it_are_scored(presenter, document):
    document.begin_live()
    document.take_live(steps()[:30])
    scored = score_now(presenter)
    fps = document.recording.fps
    assert scored.subject.frames == (0, int(int(30 / fps) * fps))
    assert scored.whole.frames == scored.subject.frames[1]
    before = presenter.current_subject()
    document.take_live(steps()[30:31])
    assert presenter.current_subject() == before
    document.end_live()
    assert presenter.current_subject().frames == document.tracks.frames


def test_at_the_start_of_a_second_run_the_figures_are_said_to_be_of_the_tracks_before(
    presenter, document
):
    score_now(presenter)
    document.begin_live()
    scene = presenter.scene("")
    assert scene.rows
    assert "these figures are of the tracks before" in scene.message
    assert "Track the recording first" not in scene.message


def test_without_tracks_there_is_nothing_to_score(document):
    presenter = ScoringPresenter(Document(document.recording))
    assert presenter.current_subject() is None
    assert "Track the recording first" in presenter.scene("").message


CLASSES = {1: (1, 1), 2: (1, 3), 3: (1, 8), 4: (0, 1)}
"""Confidence and class: a person, a car, a distractor, a person nobody counts."""


def test_a_truth_with_classes_counts_as_on_the_command_line(presenter, tmp_path):
    truth = tmp_path / "gt.txt"
    rows = [
        f"{frame},{who},{100 * who},20,30,60,{conf},{kind},1"
        for who, (conf, kind) in reversed(CLASSES.items())
        for frame in range(1, 6)
    ]
    truth.write_text("\n".join(rows))
    presenter.choose_file(truth)
    scored = score_now(presenter)
    typed = true_table(truth_at(truth))
    for name in ("frame", "track", "box", "counted", "dont_care"):
        np.testing.assert_array_equal(getattr(scored.truth.table, name), getattr(typed, name))
    assert scored.whole.truth_people == 1
    assert scored.truth.people.track_ids == (1,)


def test_a_truth_of_ids_from_0_is_drawn_with_the_one_after_the_highest(presenter, tmp_path):
    truth = tmp_path / "gt.txt"
    truth.write_text("1,0,10,20,30,60,1\n1,6,90,20,30,60,1\n")
    presenter.choose_file(truth)
    scored = score_now(presenter)
    assert scored.truth.people.track_ids == (6, 7)
    assert scored.whole.truth_people == 2


KITTI = "{} {} {} 0 0 -10 {} 20 {} 80 -1 -1 -1 -1000 -1000 -1000 -10"


def test_what_is_no_person_in_files_of_other_tools_is_no_truth(presenter, tmp_path):
    truth = tmp_path / "0000.txt"
    kinds = {1: "Pedestrian", 2: "Car", -1: "DontCare"}
    rows = [
        KITTI.format(frame, who, kind, 100 * who, 100 * who + 30)
        for frame in range(5)
        for who, kind in kinds.items()
    ]
    truth.write_text("\n".join(rows))
    presenter.choose_file(truth)
    scored = score_now(presenter)
    typed = truth_at(truth)
    assert set(typed.columns["track"].tolist()) == set(scored.truth.people.track_ids) == {1}
    notes = (
        "5 regions nobody cares about (DontCare) are left out",
        "1 track that is no person is left out",
    )
    assert typed.notes == scored.truth.notes == notes


def test_how_sure_a_tracker_was_makes_no_row_of_a_table_a_dont_care(presenter, tmp_path):
    rows = "".join(f"{frame},1,100,20,30,60,0\n" for frame in range(5))
    truth, text = tmp_path / "t.csv", tmp_path / "t.txt"
    truth.write_text("frame,track,left,top,width,height,confidence\n" + rows)
    text.write_text("".join(f"{1 + frame},1,100,20,30,60,0\n" for frame in range(5)))
    for path, rows_of_truth in ((truth, 5), (text, 0)):
        presenter.choose_file(path)
        assert int(score_now(presenter).truth.table.counted.sum()) == rows_of_truth
        assert int(true_table(truth_at(path)).counted.sum()) == rows_of_truth


def compare_runs(document, run, base):
    session = document.session
    comparison = Comparison(session, run, base, fps=25.0, colour_of=document.colour_of)
    document.comparison = comparison
    return comparison


def test_of_two_compared_runs_the_one_that_is_scored_has_the_errors(presenter, document, tiny_run):
    document.session.add_run(tiny_run)
    compare_runs(document, 1, None)
    assert presenter.scored_version.version is ErrorsOf.SOLID
    presenter.choice.track_source = 1
    scored = presenter.scored_version
    assert scored.version is ErrorsOf.DASHED
    assert "Run 1" in scored.name
    frame = int(tiny_run.tracks["frame"][0])
    rows = scored.rows(document.corrected_state(frame))
    assert (
        rows["track"].tolist()
        == tiny_run.tracks["track"][tiny_run.tracks["frame"] == frame].tolist()
    )


def test_errors_of_neither_of_two_compared_runs_are_not_drawn_and_it_is_said(
    presenter, document, tiny_run
):
    score_now(presenter)
    document.session.add_run(tiny_run)
    compare_runs(document, 1, 0)
    scored = presenter.scored_version
    frame = int(presenter.scored.errors.frame[0])
    state = document.corrected_state(frame)
    picture = presenter.people.picture(Side.LEFT, state, scored)
    assert not picture.alarms
    assert all(one.wrong is None for one in picture.people)
    assert any("Corrected tracks" in entry.text for entry in picture.legend)
