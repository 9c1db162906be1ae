"""`import`: tracks made elsewhere into a session, and back out again."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from command_line import Trackwright

from tracking.editing import keyframes_of, plan_delete, plan_move_box, plan_rename
from tracking.formats import read_mot
from tracking.session import Session
from tracking.tracks import Source

BOX = ("left", "top", "width", "height")
GOOD = "1,1,10,10,20,40,1\n2,1,11,10,20,40,1\n3,1,12,10,20,40,1\n"


def written(folder: Path, text: str, name: str = "tracks.txt") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def test_imported_tracks_are_a_run_of_their_own(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    truth = footage / "truth.txt"
    status, printed, _ = trackwright("import", truth, "--recording", footage, "-o", out, "--json")
    report = json.loads(printed)
    assert status == 0
    assert (report["format"], report["bad_count"], report["session"]) == ("mot", 0, str(out))
    true = read_mot(truth)
    with closing(Session.open(out)) as session:
        run, rows = session.runs[0], session.tracks.columns()
        assert (run.tracker, run.frames) == ("imported", (0, 80))
        assert run.settings["file"] == "truth.txt"
        assert run.settings["size_bytes"] == truth.stat().st_size
        assert len(run.settings["sha256"]) == 64
        assert len(session.history) == 0
        assert report["rows"] == len(rows["frame"]) == len(true["frame"])
        order = np.lexsort((true["track"], true["frame"]))
        for name in ("track", *BOX, "x", "y"):
            np.testing.assert_array_equal(rows[name], true[name][order])
    scored = json.loads(trackwright("score", out, "--truth", footage, "--json")[1])
    assert (scored["misses"], scored["id_switches"]) == (0, 0)


@pytest.mark.parametrize("name", ["mot", "mot16", "kitti", "csv", "cvat"])
def test_what_is_exported_is_imported_as_it_was(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path, name: str
) -> None:
    made, back = tmp_path / "made.any", tmp_path / "back.h5"
    assert trackwright("export", session, "-o", made, "--format", name)[0] == 0
    status, _, err = trackwright("import", made, "--recording", footage, "-o", back)
    assert (status, "cannot be meant" in err) == (0, False)
    with closing(Session.open(session)) as before, closing(Session.open(back)) as after:
        expected, found = before.tracks.columns(), after.tracks.columns()
    boxed = np.isfinite(expected["left"])
    for column in ("frame", "track"):
        np.testing.assert_array_equal(found[column], expected[column][boxed])
    for column in BOX:
        np.testing.assert_allclose(found[column], expected[column][boxed], atol=1e-9)
    if name in ("mot", "csv"):
        np.testing.assert_allclose(found["x"], expected["x"][boxed], atol=1e-9)
    again = json.loads(trackwright("import", made, "--into", session, "--json")[1])
    assert again["changed"] is False


def test_places_come_back_from_the_camera_s_axes(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    session, made, back = recording / "s.h5", tmp_path / "0000.txt", recording / "back.h5"
    truth = recording / "truth.txt"
    for words in (
        ["import", truth, "--recording", recording, "-o", session],
        ["export", session, "-o", made, "--format", "kitti"],
        ["import", made, "--recording", recording, "-o", back],
    ):
        assert trackwright(*words)[0] == 0
    with closing(Session.open(session)) as before, closing(Session.open(back)) as after:
        expected, found = before.tracks.columns(), after.tracks.columns()
    np.testing.assert_allclose(found["y"], expected["y"], atol=1e-9)


def test_corrections_made_elsewhere_come_back_as_one_edit(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    with closing(Session.open(session)) as own:
        keyed, gone, *_ = own.tracks.track_ids
        frame = int(own.tracks.frames_of_track(keyed)[5])
        own.apply(plan_move_box(own.tracks, keyed, frame, (1.0, 2.0, 30.0, 60.0)))
        own.apply(plan_rename(own.tracks, own.labels, keyed, "red coat"))
        own.save()
    made = tmp_path / "tracks.xml"
    assert trackwright("export", session, "-o", made, "--format", "cvat")[0] == 0
    with closing(Session.open(session)) as own:
        before = own.tracks.of_track(gone)
        own.apply(plan_move_box(own.tracks, keyed, frame, (9.0, 9.0, 30.0, 60.0)))
        own.save()
    status, printed, _ = trackwright("import", made, "--into", session, "--json")
    assert (status, json.loads(printed)["changed"]) == (0, True)
    with closing(Session.open(session)) as own:
        assert own.history.entries[-1].change.kind == "import"
        assert own.history.entries[-1].change.tracks == (keyed,)
        row = own.tracks.of_track(keyed, frame, frame + 1)
        assert [row[name][0] for name in BOX] == [1, 2, 30, 60]
        assert keyframes_of(own.tracks, keyed).tolist() == [frame]
        assert own.labels.of_track(keyed).name == "red coat"
        np.testing.assert_array_equal(own.tracks.of_track(gone)["left"], before["left"])
        own.undo()
        assert own.tracks.of_track(keyed, frame, frame + 1)["left"][0] == 9


def test_no_track_goes_because_the_file_lacks_it(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    with closing(Session.open(session)) as own:
        ids = own.tracks.track_ids
        own.apply(plan_delete(own.tracks, ids[-1]))
        own.save()
    into = ["--into", session]
    assert trackwright("import", written(tmp_path, GOOD.replace(",1,1", ",900,1")), *into)[0] == 0
    with closing(Session.open(session)) as own:
        assert own.tracks.track_ids == (*ids[:-1], 900)


def test_new_ids_are_given_where_they_are_asked_for(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    with closing(Session.open(session)) as own:
        ids, highest = own.tracks.track_ids, own.tracks.highest_track
    assert trackwright("import", written(tmp_path, GOOD), "--into", session, "--as-new")[0] == 0
    with closing(Session.open(session)) as own:
        assert own.tracks.track_ids == (*ids, highest + 1)


def test_bad_rows_are_told_with_line_and_reason_and_nothing_is_written(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks = written(tmp_path, GOOD + "4,1,1,1,-5,5,1\n900,1,1,1,5,5,1\n")
    words = ["import", tracks, "--recording", footage, "-o", tmp_path / "s.h5"]
    status, out, err = trackwright(*words)
    assert (status, out) == (1, "")
    assert err.splitlines()[-1] == (
        f"trackwright: {tracks}: 1 row cannot be meant, in line 4: the box has a negative size; "
        "correct the file, or add --take-good to take the others"
    )
    assert [file.name for file in tmp_path.iterdir()] == ["tracks.txt"]
    status, out, _ = trackwright(*words, "--json")
    report = json.loads(out)
    assert (status, report["session"], report["bad_count"]) == (1, None, 1)
    assert report["bad_rows"] == [{"place": "line 4", "reason": "the box has a negative size"}]


def test_good_rows_are_taken_where_the_user_says_so(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks = written(tmp_path, GOOD + "4,1,1,1,-5,5,1\n900,1,1,1,5,5,1\n")
    out = tmp_path / "s.h5"
    words = ["import", tracks, "--recording", footage, "-o", out, "--take-good"]
    status, _, err = trackwright(*words)
    assert status == 0
    assert "line 4" in err
    told = " ".join(err.split())
    assert "line 5" in told
    assert "frame 900" in told
    with closing(Session.open(out)) as session:
        assert session.tracks.frames_of_track(1).tolist() == [0, 1, 2]


def test_boxes_outside_of_the_picture_are_noted(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    outside = "4,1,5000,4000,20,40,1\n5,1,-30,10,20,40,1\n6,1,-9,10,20,40,1\n"
    words = ["--recording", footage, "-o", tmp_path / "s.h5"]
    status, _, err = trackwright("import", written(tmp_path, GOOD + outside), *words)
    assert status == 0
    note = "note: 2 of 6 boxes lie outside of the picture: are these tracks of this recording?"
    assert note in err.splitlines()


def test_dense_tracks_are_thinned_on_request(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    rows = "".join(f"{n},5,{n + n % 2},10,20,40,1\n" for n in range(1, 61))
    out = tmp_path / "s.h5"
    words = ["--recording", footage, "-o", out, "--thin", "2", "--json"]
    printed = trackwright("import", written(tmp_path, rows), *words)[1]
    assert json.loads(printed)["thinned"] == {"tracks": 1, "boxes": 60, "keyframes": 2}
    with closing(Session.open(out)) as session:
        now, then = session.tracks.of_track(5), session.runs[0].tracks
        assert np.abs(now["left"] - (np.arange(1, 61) + np.arange(1, 61) % 2 - 1)).max() <= 2
        assert np.count_nonzero(now["source"] == Source.PERSON) == 2
        assert len(then["frame"]) == 60


def test_rows_a_truth_does_not_count_stay_so(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks = written(tmp_path, GOOD + "4,1,13,10,20,40,0\n1,2,1,1,5,5,0\n")
    session, out = tmp_path / "s.h5", tmp_path / "out.txt"
    assert trackwright("import", tracks, "--recording", footage, "-o", session)[0] == 0
    assert trackwright("export", session, "-o", out, "--format", "mot")[0] == 0
    columns = read_mot(out)
    assert columns["confidence"].tolist() == [1, 0, 1, 1, 0]


def test_imported_tracks_and_further_runs_are_not_replaced_unasked(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path
) -> None:
    tracks, out = written(tmp_path, GOOD), tmp_path / "s.h5"
    order = ["import", tracks, "--recording", footage, "-o", out]
    assert trackwright(*order)[0] == 0
    for words in (order, ["track", footage, "-o", out]):
        status, _, err = trackwright(*words)
        assert (status, "the tracks that were imported would be lost" in err) == (1, True)
    with closing(Session.open(session)) as own:
        own.add_run(own.runs[0])
        own.save()
    status, _, err = trackwright("track", footage, "-o", session)
    assert (status, "one of its runs would be lost" in err) == (1, True)
    assert trackwright(*order, "--force")[0] == 0


def test_what_is_no_person_can_be_left_out(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks = written(tmp_path, "1,1,1,1,5,5,1,1,1\n1,2,1,1,5,5,0,3,1\n1,3,1,1,5,5,0,12,1\n")
    words = ["import", tracks, "--recording", footage, "-o", tmp_path / "s.h5", "--only-people"]
    status, _, err = trackwright(*words)
    assert status == 0
    assert "2 tracks that are no people are left out" in err
    with closing(Session.open(tmp_path / "s.h5")) as session:
        assert session.tracks.track_ids == (1,)


@pytest.mark.parametrize(
    ("words", "status", "reason"),
    [
        (["-o", "{out}", "--format", "mpeg"], 1, "'mpeg' is unknown"),
        ([], 2, "name the session to make"),
        (["--into", "{session}", "-o", "{out}"], 2, "leave it out"),
        (["-o", "{session}", "--recording", "{footage}"], 1, "add --force"),
        (["-o", "{out}", "--recording", "{footage}", "--thin", "0"], 1, "above 0"),
        (["-o", "{out}"], 2, "name a recording"),
    ],
)
def test_a_wrong_order_is_told(
    trackwright: Trackwright,
    footage: Path,
    session: Path,
    tmp_path: Path,
    words: list[str],
    status: int,
    reason: str,
) -> None:
    with closing(Session.open(session)) as own:
        own.apply(plan_delete(own.tracks, own.tracks.track_ids[0]))
        own.save()
    places = {"out": tmp_path / "s.h5", "session": session, "footage": footage}
    tracks = written(tmp_path, GOOD)
    found = trackwright("import", tracks, *(word.format(**places) for word in words))
    assert found[:2] == (status, "")
    assert reason in found[2]
    assert not (tmp_path / "s.h5").exists()


@pytest.mark.parametrize("text", ["", "\n\n", "not a table at all\n", "\0\1\2", "{}", "<a/>"])
def test_what_is_no_tracks_is_refused_in_a_line(
    trackwright: Trackwright, footage: Path, tmp_path: Path, text: str
) -> None:
    tracks = written(tmp_path, text)
    words = ["import", tracks, "--recording", footage, "-o", tmp_path / "s.h5"]
    status, out, err = trackwright(*words)
    assert (status, out) == (1, "")
    assert err.count("\n") == 1
    assert "tracks.txt" in err
    assert [file.name for file in tmp_path.iterdir()] == ["tracks.txt"]


def test_a_session_is_no_file_of_another_tool(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path
) -> None:
    words = ["import", session, "--recording", footage, "-o", tmp_path / "s.h5"]
    status, _, err = trackwright(*words)
    assert status == 1
    assert (
        err == f"trackwright: {session} is a trackwright session; open it, or score it as it is\n"
    )


@pytest.mark.parametrize(
    ("size", "reason"), [(0, "is empty"), (3000, "is damaged"), (2, "of no format known here")]
)
def test_a_cut_file_is_told_apart_from_one_of_no_format(
    trackwright: Trackwright, session: Path, tmp_path: Path, size: int, reason: str
) -> None:
    cut = tmp_path / "cut.h5"
    cut.write_bytes(session.read_bytes()[:size])
    status, _, err = trackwright("import", cut, "-o", tmp_path / "s.h5")
    assert (status, err.count("\n")) == (1, 1)
    assert reason in err


def test_only_what_can_be_written_is_offered_for_an_export(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    for wrong in ("nonsense", "sleap"):
        out = tmp_path / "made.txt"
        status, _, err = trackwright("export", session, "-o", out, "--format", wrong)
        offered = err.rstrip().split("choose one of: ")[1].split(", ")
        assert status == 1
        assert {"mot", "cvat", "labels", "samples"} <= set(offered)
        assert not {"sleap", "idtracker"} & set(offered)
        assert not out.exists()
