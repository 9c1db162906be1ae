"""The file is as the contract says, and readable by others."""

from __future__ import annotations

import json
import os
import sys
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pedpy
import pytest
from made_up_sessions import FRAMES, make_recording, make_run, make_session, state_of

from tracking.editing import plan_delete, plan_rename, plan_split, plan_swap
from tracking.errors import EditError, SessionError
from tracking.session import Session, describe
from tracking.tracks import (
    CORRECTED_COLUMNS,
    DETECTION_COLUMNS,
    PART_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
)


def test_the_root_says_what_the_file_is(session: Session) -> None:
    with h5py.File(session.path) as file:
        assert file.attrs["format"] == "trackwright-session"
        assert file.attrs["format_version"] == "1.8"
        assert {"software", "created", "modified"} <= set(file.attrs)
        assert set(file) == {
            *("recording", "runs", "tracks", "labels", "edits", "samples", "trajectory", "colours")
        }


@pytest.mark.parametrize(
    ("group", "types"),
    [
        ("runs/0/tracks", TRACK_COLUMNS),
        ("runs/0/detections", DETECTION_COLUMNS),
        ("runs/0/particles", PARTICLE_COLUMNS),
        ("runs/0/parts", PART_COLUMNS),
        ("tracks", CORRECTED_COLUMNS),
    ],
)
def test_tables_are_columns_of_equal_length(session: Session, group: str, types: dict) -> None:
    with h5py.File(session.path) as file:
        columns = {name: file[group][name] for name in types}
        assert {name: column.dtype for name, column in columns.items()} == dict(types)
        assert len({column.shape for column in columns.values()}) == 1


def test_the_corrected_table_is_the_first_run_s(session: Session) -> None:
    run = make_run()
    with h5py.File(session.path) as file:
        for name in TRACK_COLUMNS:
            assert file[f"tracks/{name}"][()].tobytes() == run.tracks[name].tobytes()
        assert not file["tracks/source"][()].any()


def test_a_run_comes_back_bit_for_bit(session: Session) -> None:
    path, run = session.path, make_run()
    session.close()
    assert path is not None
    again = Session.open(path)
    read = again.runs[0]
    again.close()
    assert (read.tracker, read.settings, read.seed) == (run.tracker, run.settings, run.seed)
    assert (read.frames, read.software) == (run.frames, run.software)
    for table in ("tracks", "detections", "associations"):
        for name, column in getattr(run, table).items():
            assert getattr(read, table)[name].tobytes() == column.tobytes()
    for name, column in run.particles.columns.items():
        assert np.asarray(read.particles.columns[name]).tobytes() == np.asarray(column).tobytes()
    for frame in (0, 17, FRAMES - 1, FRAMES):
        wanted, found = run.particles.of_frame(frame), read.particles.of_frame(frame)
        assert all(found[name].tobytes() == wanted[name].tobytes() for name in wanted)


def test_particles_across_the_file_s_pieces_come_back_whole(tmp_path: Path) -> None:
    run = make_run(tracks=3, frames=9, particles=5000)  # 135,000 rows: three pieces
    recording = make_recording(tmp_path / "recording")
    Session.create(recording, [run], tmp_path / "s.h5").close()
    again = Session.open(tmp_path / "s.h5")
    for frame in range(9):
        wanted, found = run.particles.of_frame(frame), again.runs[0].particles.of_frame(frame)
        assert all(found[name].tobytes() == wanted[name].tobytes() for name in wanted)
    again.close()


def test_pedpy_loads_the_corrected_positions(session: Session) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    session.save()
    loaded = pedpy.load_trajectory_from_ped_data_archive_hdf5(trajectory_file=session.path)
    rows = session.tracks.columns()
    known = np.isfinite(rows["x"])
    assert loaded.frame_rate == 20.0
    data = loaded.data.sort_values(["frame", "id"])
    assert data["id"].tolist() == rows["track"][known].tolist()
    assert data["frame"].tolist() == rows["frame"][known].tolist()
    assert data["x"].tolist() == rows["x"][known].tolist()


def test_the_log_stands_in_the_file(session: Session) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    session.undo()
    session.save()
    with h5py.File(session.path) as file:
        edits = file["edits"]
        assert edits["id"][()].tolist() == [1, 2]
        assert edits["kind"].asstr()[()].tolist() == ["swap", "rename"]
        assert edits["author"].asstr()[()].tolist() == ["ada", "ada"]
        assert edits["undone"][()].tolist() == [False, True]
        before = json.loads(edits["before"].asstr()[0])
        assert [stretch[0] for stretch in before["stretches"]] == [1, 2]


def test_labels_stand_in_the_file(session: Session) -> None:
    session.apply(plan_rename(session.tracks, session.labels, 2, "赤いコート"))
    session.save()
    with h5py.File(session.path) as file:
        assert file["labels/track"][()].tolist() == [2]
        assert file["labels/name"].asstr()[()].tolist() == ["赤いコート"]
        assert file["labels/attributes"].asstr()[()].tolist() == ["{}"]


def test_the_same_edits_give_the_same_arrays(tmp_path: Path) -> None:
    arrays = []
    for name in ("one", "two"):
        made = make_session(tmp_path / name)
        made.apply(plan_swap(made.tracks, 1, 2, 10))
        arrays.append(arrays_of(made.save()))
        made.close()
    assert arrays[0] == arrays[1]


def arrays_of(path: Path) -> dict[str, bytes]:
    found: dict[str, bytes] = {}

    def visit(name: str, node: object) -> None:
        if isinstance(node, h5py.Dataset) and node.dtype.kind != "O":
            found[name] = node[()].tobytes()

    with h5py.File(path) as file:
        file.visititems(visit)
    return found


def test_saving_twice_changes_nothing_in_the_arrays(session: Session) -> None:
    before = arrays_of(session.save())
    assert arrays_of(session.save()) == before


def test_a_session_without_runs_or_people_is_one(tmp_path: Path) -> None:
    recording = make_recording(tmp_path / "recording")
    Session.create(recording, (), tmp_path / "s.h5").close()
    again = Session.open(tmp_path / "s.h5")
    assert (len(again.tracks), len(again.runs), again.adopted_run) == (0, 0, None)
    again.close()
    pedpy.load_trajectory_from_ped_data_archive_hdf5(trajectory_file=tmp_path / "s.h5")


def test_a_later_run_becomes_the_table_only_while_nobody_edited(session: Session) -> None:
    session.add_run(make_run(seed=1))
    assert session.adopted_run == 1
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    before = state_of(session)
    session.add_run(make_run(seed=2))
    assert session.adopted_run == 1
    assert state_of(session) == before
    session.save()
    assert [session.runs[number].seed for number in range(3)] == [0, 1, 2]


def test_any_run_can_be_begun_with_while_nobody_edited(session: Session, tmp_path: Path) -> None:
    session.add_run(make_run(seed=1, tracks=6))
    session.adopt_run(0)
    assert session.adopted_run == 0
    assert len(session.tracks.track_ids) == len(np.unique(session.runs[0].tracks["track"]))
    path = session.save(tmp_path / "kept.h5")
    session.close()
    again = Session.open(path)
    assert (again.adopted_run, len(again.runs)) == (0, 2)
    again.close()


def test_no_run_takes_the_place_of_edited_tracks(session: Session) -> None:
    session.add_run(make_run(seed=1))
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    before = state_of(session)
    with pytest.raises(EditError, match="take from the run"):
        session.adopt_run(0)
    assert state_of(session) == before


def test_no_run_of_fewer_frames_takes_the_place_of_the_tracks(session: Session) -> None:
    whole = session.runs[0]
    session.add_run(replace(make_run(seed=1), frames=(whole.frames[0] + 1, whole.frames[1])))
    before = state_of(session)
    with pytest.raises(EditError, match="alone; take from the run"):
        session.adopt_run(1)
    assert (session.adopted_run, state_of(session)) == (0, before)


def test_a_run_that_is_no_table_is_refused(session: Session) -> None:
    run = make_run()
    run.tracks["frame"][:] = run.tracks["frame"][::-1].copy()
    with pytest.raises(EditError, match="out of order"):
        session.add_run(run)
    assert len(session.runs) == 1


def test_ids_of_deleted_tracks_stay_used_after_reopening(session: Session) -> None:
    last = max(session.tracks.track_ids)
    session.apply(plan_delete(session.tracks, last))
    path = session.save()
    session.close()
    again = Session.open(path)
    assert plan_split(again.tracks, 1, 10).tracks == (1, last + 1)
    again.close()


def test_info_tells_what_the_session_holds(session: Session) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, 10))
    told = describe(session.save())
    assert (told["frames"], told["fps"], told["size"]) == (FRAMES, 20.0, [640, 480])
    assert (told["tracks"], told["edits"], told["undone_edits"]) == (4, 1, 0)
    run = {"tracker": "stereo-direction", "frames": [0, FRAMES], "seed": 0, "detector": ""}
    run |= {"detector_from": None, "settings": {"eta": 0.25, "particles": 10}, "notes": []}
    run |= {"detections_input": []}
    assert told["runs"] == [run]
    assert told["recording"] == "recording"
    json.dumps(told)


def test_tables_of_a_run_are_sorted_by_frame_then_track(tmp_path: Path) -> None:
    run = make_run()
    backwards = {name: column[::-1].copy() for name, column in run.detections.items()}
    made = Session.create(
        make_recording(tmp_path / "recording"),
        [replace(run, detections=backwards)],
        tmp_path / "s.h5",
    )
    made.close()
    with h5py.File(tmp_path / "s.h5") as file:
        for table in ("tracks", "detections", "associations", "parts"):
            group = file[f"runs/0/{table}"]
            rows = list(zip(group["frame"][()], group["track"][()], strict=True))
            assert rows == sorted(rows)
        kept = {name: file[f"runs/0/detections/{name}"][()] for name in run.detections}
    np.testing.assert_equal(kept, dict(run.detections))


@pytest.mark.skipif(sys.platform != "linux", reason="names are text elsewhere")
def test_a_recording_whose_name_is_no_text_is_kept_as_well_as_a_file_can(tmp_path: Path) -> None:
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    recording = replace(make_recording(folder), name=folder.name)
    made = Session.create(recording, [make_run()], tmp_path / "s.h5")
    made.close()
    again = Session.open(tmp_path / "s.h5")
    assert (again.recording.name, again.recording.path) == ("caf?", "caf?")
    again.close()


def test_a_session_of_a_newer_trackwright_is_not_saved_over(session: Session) -> None:
    path = session.save()
    session.close()
    with h5py.File(path, "a") as file:
        file.attrs["format_version"] = "1.9"
        file.create_dataset("from_later/feature", data=np.arange(3.0))
    before = path.read_bytes()
    again = Session.open(path)
    assert again.read_only
    assert "newer trackwright" in again.notes[0]
    with pytest.raises(SessionError, match="another name"):
        again.save()
    again.close()
    assert path.read_bytes() == before
