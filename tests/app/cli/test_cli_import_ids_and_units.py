"""Track 0 of files that count from it, and places that do not say their unit."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

from command_line import Trackwright
from import_files import GOOD, written

from tracking.session import Session

ZERO = "# a tracker that counts ids from 0\n1,0,50,60,20,40,1\n2,0,51,60,20,40,1\n"


def ids_in(path: Path) -> list[int]:
    with closing(Session.open(path)) as session:
        return list(session.tracks.track_ids)


def test_track_0_becomes_the_one_after_the_highest_which_is_told(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    tracks = written(tmp_path, ZERO + GOOD)
    status, _, err = trackwright("import", tracks, "--recording", footage, "-o", out)
    assert (status, ids_in(out)) == (0, [1, 2])
    assert "track 0 of the file is track 2 here" in err


def test_track_0_takes_the_place_of_no_track_of_a_session_and_comes_once(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    drawn = written(tmp_path, "5,1,1,1,9,9,1\n5,2,90,1,9,9,1\n", "drawn.txt")
    assert trackwright("import", drawn, "--recording", footage, "-o", out)[0] == 0
    tracks = written(tmp_path, ZERO + GOOD)
    status, printed, _ = trackwright("import", tracks, "--into", out, "--json")
    assert (status, ids_in(out)) == (0, [1, 2, 3])
    assert "track 0 of the file is track 3 here: ids are positive" in json.loads(printed)["notes"]
    with closing(Session.open(out)) as session:
        assert session.tracks.of_track(2)["left"].tolist() == [89]
    again = json.loads(trackwright("import", tracks, "--into", out, "--json")[1])
    assert (again["changed"], ids_in(out)) == (False, [1, 2, 3])
    named = json.loads(trackwright("import", tracks, "--into", out, "--as-new", "--json")[1])
    assert ids_in(out) == [1, 2, 3, 4, 5]
    assert "track 0 of the file is track 5 here: ids are positive" in named["notes"]


def test_a_result_with_track_0_scores_as_under_another_id(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    truth = written(tmp_path, ZERO.replace(",0,", ",4,") + GOOD, "truth.txt")
    result = written(tmp_path, ZERO + GOOD, "result.txt")
    status, printed, err = trackwright("score", result, "--truth", truth, "--json")
    assert (status, err) == (0, "")
    scored = json.loads(printed)
    assert (scored["MOTA"], scored["IDF1"], scored["result_tracks"]) == (1.0, 1.0, 2)


PLACES = "1 0 100 400 170\n1 1 110 400 170\n"


def test_places_without_a_unit_are_taken_in_the_one_that_is_named(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    out, tracks = tmp_path / "s.h5", written(tmp_path, PLACES)
    words = ["import", tracks, "--recording", footage, "-o", out]
    status, _, err = trackwright(*words)
    assert (status, err.count("\n"), "--unit cm" in err) == (1, 1, True)
    assert trackwright(*words, "--unit", "inch")[0] == 2
    assert trackwright(*words, "--unit", "cm")[0] == 0
    with closing(Session.open(out)) as session:
        assert session.tracks.columns()["x"].tolist() == [1.0, 1.1]
    boxes = written(tmp_path, GOOD, "boxes.txt")
    status, _, err = trackwright("import", boxes, "--into", out, "--unit", "cm")
    assert (status, "has a unit of its own" in err) == (2, True)
    status, _, err = trackwright("import", tracks, "--into", out, "--unit", "cm", "--fps", "99")
    assert (status, "the file is of 99 frames per second" in err) == (0, True)


def test_places_without_a_unit_are_scored_in_the_one_that_is_named(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    truth = written(tmp_path, "# framerate: 25\n# id frame x/m y/m\n1 0 1 4\n1 1 1.1 4\n", "t.txt")
    words = ["score", written(tmp_path, PLACES), "--truth", truth, "--match", "floor", "--json"]
    assert trackwright(*words)[0] == 1
    status, printed, err = trackwright(*words, "--unit", "cm", "--fps", "25")
    assert (status, json.loads(printed)["MOTA"]) == (0, 1.0)
    assert "the file says m itself; cm is passed over" in err
