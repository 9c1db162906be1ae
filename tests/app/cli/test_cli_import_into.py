"""`import --into`: tracks made elsewhere into a session that is there."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

import numpy as np
from command_line import Trackwright
from import_files import BOX, GOOD, written

from tracking.editing import keyframes_of, plan_delete, plan_move_box, plan_rename
from tracking.session import Session


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
