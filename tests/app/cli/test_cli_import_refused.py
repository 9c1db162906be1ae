"""`import`: files and options that are refused, in one line."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright
from import_files import GOOD, written

from tracking.editing import plan_delete
from tracking.session import Session


def test_bad_rows_are_told_with_line_and_reason_and_nothing_is_written(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks = written(tmp_path, GOOD + "4,1,1,1,-5,5,1\n900,1,1,1,5,5,1\n")
    words = ["import", tracks, "--recording", footage, "-o", tmp_path / "s.h5"]
    status, out, err = trackwright(*words)
    assert (status, out) == (1, "")
    assert err.splitlines()[-1] == (
        f"trackwright: {tracks}: 1 row is invalid, in line 4: the box has a negative size; "
        "correct the file, or add --take-good to import the others"
    )
    assert [file.name for file in tmp_path.iterdir()] == ["tracks.txt"]
    assert trackwright(*words, "--json")[:2] == (1, "")
    status, out, err = trackwright(*words, "--report")
    assert (status, out) == (1, "")
    assert "line 4" in "".join(err.splitlines()[:-1])


def test_good_rows_are_taken_where_the_user_says_so(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks = written(tmp_path, GOOD + "4,1,1,1,-5,5,1\n900,1,1,1,5,5,1\n")
    out = tmp_path / "s.h5"
    words = ["import", tracks, "--recording", footage, "-o", out, "--take-good", "--report"]
    status, _, err = trackwright(*words)
    assert status == 0
    assert "line 4" in err
    told = " ".join(err.split())
    assert "line 5" in told
    assert "frame 900" in told
    with closing(Session.open(out)) as session:
        assert session.tracks.frames_of_track(1).tolist() == [0, 1, 2]


@pytest.mark.parametrize(
    ("words", "status", "reason"),
    [
        (["-o", "{out}", "--format", "mpeg"], 2, "'mpeg' is unknown"),
        ([], 2, "name the session to make"),
        (["--into", "{session}", "-o", "{out}"], 2, "leave it out"),
        (["-o", "{session}", "--recording", "{footage}"], 1, "add --force"),
        (["-o", "{out}", "--recording", "{footage}", "--thin", "0"], 2, "above 0"),
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
        offered = err.split("choose one of: ")[1].partition("; see")[0].split(", ")
        assert status == 2
        assert {"mot", "cvat", "labels", "samples"} <= set(offered)
        assert not {"sleap", "idtracker"} & set(offered)
        assert not out.exists()
