"""`import`: tracks made elsewhere into a new session, and back out again."""

from __future__ import annotations

import json
import shutil
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from command_line import Trackwright
from import_files import BOX, GOOD, written

from tracking.formats import read_mot
from tracking.session import Session
from tracking.tracks import Source


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


@pytest.mark.parametrize(
    "name", ["mot", "mot16", "kitti", "csv", "cvat", "label-studio", "x-anylabeling", "viame"]
)
def test_what_is_exported_is_imported_as_it_was(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path, name: str
) -> None:
    made, back = tmp_path / "made.any", tmp_path / "back.h5"
    assert trackwright("export", session, "-o", made, "--format", name)[0] == 0
    status, _, err = trackwright("import", made, "--recording", footage, "-o", back)
    assert (status, "invalid" in err) == (0, False)
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


def test_percent_of_a_picture_are_told_by_the_recording_s_size(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    keyframe = {"frame": 1, "enabled": False, "x": 50, "y": 25, "width": 10, "height": 20}
    regions = [{"framesCount": 80, "sequence": [keyframe], "labels": ["person"]}]
    made = written(tmp_path, json.dumps([{"id": 1, "video": "a.mp4", "box": regions}]), "min.json")
    alone = shutil.copy(footage / "truth.txt", tmp_path)
    status, _, err = trackwright("score", made, "--truth", alone)
    assert status == 1
    assert "import it with its recording" in err
    out = tmp_path / "s.h5"
    assert trackwright("import", made, "--recording", footage, "-o", out)[0] == 0
    assert json.loads(trackwright("import", made, "--into", out, "--json")[1])["changed"] is False
    with closing(Session.open(out)) as session:
        width, height = session.recording.size
        columns = session.tracks.columns()
    box = [columns[name].tolist() for name in BOX]
    assert box == [[width / 2], [height / 4], [width / 10], [height / 5]]


def test_a_folder_of_files_is_imported_and_never_written_over(
    trackwright: Trackwright, footage: Path, session: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "frames"
    words = ["export", session, "-o", folder, "--format", "x-anylabeling"]
    assert trackwright(*words)[0] == 0
    status, _, err = trackwright(*words)
    assert (status, "is not an empty folder" in err.splitlines()[-1]) == (1, True)
    out = tmp_path / "s.h5"
    assert trackwright("import", folder, "--recording", footage, "-o", out)[0] == 0
    with closing(Session.open(out)) as made:
        settings = made.runs[0].settings
    sizes = [file.stat().st_size for file in folder.iterdir()]
    assert (settings["file"], settings["size_bytes"]) == ("frames", sum(sizes))


def test_points_of_heads_with_names_get_no_places_from_feet_on_any_way(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    """What the file says of a track is an edit of the new session, which tells no places either."""
    person = "0 -100000 0 0 1 -1 -1 -1 -1 1\nwith a bag\n{} 90 -1 -1 -1 100 0 0 -1 -1 -1 -1\n"
    made = written(tmp_path, f"version 4\n1\n{person.format(100)}", "t.trc")
    out = tmp_path / "s.h5"
    status, _, err = trackwright("import", made, "--recording", footage, "-o", out)
    assert (status, "no places on the floor" in err) == (0, True)
    moved = written(tmp_path, f"version 4\n1\n{person.format(120)}", "moved.trc")
    assert trackwright("import", moved, "--into", out)[0] == 0
    with closing(Session.open(out)) as session:
        columns = session.tracks.columns()
    assert columns["left"].tolist() == [120]
    assert np.isnan(columns["x"]).all()


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


def test_boxes_outside_of_the_picture_are_noted(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    outside = "4,1,5000,4000,20,40,1\n5,1,-30,10,20,40,1\n6,1,-9,10,20,40,1\n"
    words = ["--recording", footage, "-o", tmp_path / "s.h5"]
    status, _, err = trackwright("import", written(tmp_path, GOOD + outside), *words)
    assert status == 0
    note = "note: 2 of 6 boxes lie outside of the image: are these tracks of this recording?"
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
