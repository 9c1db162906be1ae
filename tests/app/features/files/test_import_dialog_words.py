"""What is told of a file before its tracks are taken."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from two_people import FRAMES, table

from app.features.files.track_import import (
    FittedTracks,
    ImportChoice,
    import_scene,
    prepare_fit,
    read_tracks,
    with_good,
)
from tracking.editing import apply_change
from tracking.errors import FormatError
from tracking.formats import Filmed
from tracking.tracks import Labels

FILMED = Filmed(FRAMES, 20.0, (640, 480))
ROW = "{frame},{track},{left},20,30,60,1,-1,-1,-1"


def quiet(_done: int, _total: int) -> None:
    """Nobody watches."""


@pytest.fixture
def read(tmp_path: Path) -> Callable:
    """Reads rows of (frame, track, left) written as MOT text, and further lines."""

    def reading(rows, *others: str):
        path = tmp_path / "theirs.txt"
        lines = [ROW.format(frame=f + 1, track=t, left=x + 1) for f, t, x in rows]
        path.write_text("\n".join([*lines, *others]) + "\n")
        return read_tracks(path, FILMED, None, quiet)

    return reading


def fitted(found, choice=ImportChoice(), into=None) -> FittedTracks:  # noqa: B008 - a frozen value
    return prepare_fit(found, choice, into, Labels())(quiet)


def straight(track: int) -> list[tuple[int, int, float]]:
    return [(frame, track, 2.0 * frame) for frame in range(40)]


def test_what_becomes_of_the_sessions_own_tracks_is_told(read):
    own = table()
    found = read([*straight(4), *straight(50)])
    scene = import_scene(found, fitted(found, into=own), len(own.track_ids))
    told = " ".join(scene.lines)
    assert "2 tracks, 80 rows, frames 0 to 39" in told
    assert "1 is added" in told
    assert "1 has the id of a track in the session" in told
    assert f"{FRAMES - 40} rows of these tracks are not in the file and are deleted" in told
    assert "1 track of the session is not in the file and stays as it is" in told
    assert scene.why_not == ""


def test_no_other_track_is_touched_and_all_of_it_is_undone_at_once(read):
    own = table()
    before = own.columns()
    found = read([*straight(4), *straight(50)])
    change = fitted(found, into=own.snapshot()).written.change
    apply_change(own, Labels(), change)
    assert set(own.track_ids) == {4, 7, 50}
    assert own.of_track(4)["frame"].tolist() == list(range(40))
    apply_change(own, Labels(), change.inverse)
    for name, column in own.columns().items():
        np.testing.assert_array_equal(column, before[name])


def test_bad_rows_are_told_with_line_and_reason_and_good_ones_wait_for_a_word(read):
    found = read(straight(9), "5,-2,1,1,1,1,1,-1,-1,-1", f"{FRAMES + 9},9,1,1,1,1,1,-1,-1,-1")
    seen = fitted(found, into=table())
    scene = import_scene(found, seen, 2)
    assert scene.bad_count == 2
    assert scene.bad[0][0] == "line 41"
    assert scene.bad[1] == (
        "line 42",
        f"track 9 is in frame {FRAMES + 9}, the recording has only {FRAMES} frames, "
        "counted from 1 in this file",
    )
    assert "other rows" in scene.why_not
    assert import_scene(found, with_good(seen, True), 2).why_not == ""


def test_thinning_says_how_few_keyframes_are_left(read):
    found = read(straight(9))
    thinned = fitted(found, ImportChoice(thins=True, thin_px=2.0), table())
    scene = import_scene(found, thinned, 2)
    assert "1 of them thinned: 40 boxes to 2 keyframes" in " ".join(scene.lines)
    assert len(thinned.found.rows["frame"]) == 40


def test_with_new_ids_no_own_track_is_touched(read):
    own = table()
    found = read(straight(4))
    seen = fitted(found, ImportChoice(as_new=True), own)
    assert seen.known == 0
    assert seen.written.change.tracks == (8,)


def test_what_the_session_says_already_is_no_import(read):
    own = table()
    found = read(straight(9))
    apply_change(own, Labels(), fitted(found, into=own.snapshot()).written.change)
    again = fitted(found, into=own)
    assert import_scene(found, again, 3).why_not == "The session has these tracks already."


def test_what_is_no_file_of_tracks_is_refused(tmp_path):
    noise = tmp_path / "noise.bin"
    noise.write_bytes(bytes(range(256)))
    with pytest.raises(FormatError):
        read_tracks(noise, FILMED, None, quiet)
