"""Files that are damaged, of another program or made to harm are refused in one line."""

from __future__ import annotations

import random
import shutil
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_sessions import make_session, state_of

from tests.pace import spent
from tracking.editing import plan_delete, plan_rename
from tracking.errors import SessionError, TrackwrightError
from tracking.session import Session, describe, inspection
from tracking.session.inspection import inspect
from tracking.session.seal import holds as is_sealed
from tracking.untrusted import Refused, limit, verdicts_of


@pytest.fixture
def look_over() -> None:
    """Look files over as the program does: in a process of its own."""


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session with edits and labels, closed."""
    session = make_session(tmp_path_factory.mktemp("good"))
    session.apply(plan_delete(session.tracks, 2))
    session.apply(plan_rename(session.tracks, session.labels, 1, "red coat"))
    path = session.save()
    session.close()
    return path


@pytest.fixture
def copy(good: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(good, tmp_path / "s.h5"))


def refused(path: Path, why: str) -> None:
    before = sorted(path.parent.iterdir())
    with pytest.raises(SessionError, match=why) as told:
        Session.open(path)
    assert str(path) in str(told.value)
    assert "\n" not in str(told.value)
    assert len(str(told.value)) < len(str(path)) + 600
    assert sorted(path.parent.iterdir()) == before


def test_a_session_without_its_seal_is_looked_over_and_opened_quickly(copy: Path) -> None:
    copy.write_bytes(copy.read_bytes() + b" ")
    assert not is_sealed(copy)
    paces = []
    for _ in range(3):  # the least, since others work on this machine, too
        with spent() as time:
            Session.open(copy).close()
        paces.append(time.paces)
    assert min(paces) < 100


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "is empty"),
        (b"frame,id,left,top\n" * 100, "is not an HDF5 file"),
        (b"\x89HDF\r\n\x1a\n" + bytes(4000), "damaged or cut short"),
    ],
)
def test_what_is_no_hdf5_is_refused(tmp_path: Path, data: bytes, why: str) -> None:
    path = tmp_path / "s.h5"
    path.write_bytes(data)
    refused(path, why)


def test_a_missing_file_and_a_folder_are_refused(tmp_path: Path) -> None:
    with pytest.raises(SessionError, match="no such session"):
        Session.open(tmp_path / "none.h5")
    with pytest.raises(SessionError, match="this is a folder"):
        describe(tmp_path)


def test_a_path_that_looks_like_an_option_is_a_path(good: Path, tmp_path: Path) -> None:
    session = Session.open(Path(shutil.copy(good, tmp_path / "-c.h5")))
    assert session.path.name == "-c.h5"
    session.close()


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 0.97])
def test_a_file_cut_short_is_refused(copy: Path, share: float) -> None:
    data = copy.read_bytes()
    copy.write_bytes(data[: int(len(data) * share)])
    refused(copy, "damaged or cut short")


def spoiled(copy: Path, spoil: Callable[[h5py.File], object]) -> Path:
    with h5py.File(copy, "a") as file:
        spoil(file)
    return copy


def replaced(file: h5py.File, name: str, **how: object) -> None:
    """Another dataset under a name the session has."""
    del file[name]
    file.create_dataset(name, **how)


def nested(file: h5py.File) -> None:
    group = file["samples"]
    for _ in range(50):
        group = group.create_group("deeper")


def virtual(file: h5py.File) -> None:
    layout = h5py.VirtualLayout((5,), "f8")
    layout[:] = h5py.VirtualSource("/etc/passwd", "x", (5,))
    file.create_virtual_dataset("samples/x", layout)


LONG = "9" * 2_000_000


def circle(file: h5py.File) -> None:
    file["samples/again"] = file["samples"]


@pytest.mark.parametrize(
    ("spoil", "why"),
    [
        (lambda file: file.attrs.__delitem__("format"), "of another program"),
        (lambda file: file.attrs.__setitem__("format", "other"), "of another program"),
        (lambda file: file.attrs.__setitem__("format_version", "2.0"), "newer trackwright"),
        (lambda file: file.attrs.__setitem__("format_version", "x"), "names 'x'"),
        (lambda file: file.attrs.__setitem__("format_version", 99), "not like 1.0; choose"),
        (lambda file: file.attrs.__setitem__("format_version", "0.9"), "never was"),
        (lambda file: file.attrs.__setitem__("session", 5), "damaged"),
        (lambda file: file["tracks"].attrs.__delitem__("highest_track"), "damaged"),
        (lambda file: file.__delitem__("edits"), "has no column id in edits"),
        (lambda file: file.__delitem__("runs"), "number its runs"),
        (lambda file: file.move("runs/0", "runs/7"), "number its runs"),
        (lambda file: file.__delitem__("tracks/left"), "has no column left in tracks"),
        (lambda file: replaced(file, "tracks/left", data=np.zeros(3)), "different lengths"),
        (lambda file: replaced(file, "tracks/left", data=["a"]), "not float64"),
        (lambda file: replaced(file, "tracks/left", data=np.zeros((3, 3))), "2 dimensions"),
        (lambda file: replaced(file, "recording/manifest", data=5), "no text at"),
        (
            lambda file: replaced(file, "tracks/left", shape=(10**12,), dtype="f8", chunks=(4096,)),
            "1000000000000 rows",
        ),
        (
            lambda file: file.create_dataset("samples/x", (10**9,), "f8", chunks=(10**8,)),
            "pieces larger",
        ),
        (
            lambda file: file.create_dataset(
                "samples/x", (5,), "f8", external=[("/etc/passwd", 0, 40)]
            ),
            "in other files",
        ),
        (
            lambda file: file.create_dataset("samples/x", data=np.zeros(5), compression="lzf"),
            "filter of its own",
        ),
        (
            lambda file: file.create_dataset("samples/x", data=file.ref, dtype=h5py.ref_dtype),
            "references",
        ),
        (
            lambda file: file.create_dataset("samples/x", (2,), h5py.vlen_dtype(np.int32)),
            "references or lists",
        ),
        (lambda file: file.__setitem__("samples/x", h5py.ExternalLink("o.h5", "/")), "link to"),
        (lambda file: file.__setitem__("samples/x", h5py.SoftLink("/tracks")), "link to"),
        (lambda file: file.__setitem__("samples/x", np.dtype("f8")), "no table"),
        (virtual, "in other files"),
        (nested, "nested deeper"),
        (circle, "nested deeper"),
        (lambda file: file["samples"].attrs.create("x", np.zeros(4, "S4")), "attribute 'x'"),
        (
            lambda file: file["recording"].attrs.__setitem__("name", LONG),
            "an attribute 'name' like",
        ),
        (lambda file: file["runs/0"].attrs.create("x", [LONG[:800]] * 2000), "an attribute 'x'"),
        (
            lambda file: file.attrs.__setitem__("format_version", f"1.x{LONG[:60_000]}"),
            "names '1.x9",
        ),
        (lambda file: file["recording"].attrs.__setitem__("fps", np.nan), "fps is nan"),
        (lambda file: file["recording"].attrs.__setitem__("frame_count", 10**15), "frame_count"),
        (lambda file: file["recording"].attrs.__setitem__("width", -1), "width is -1"),
        (lambda file: file["tracks"].attrs.__setitem__("highest_track", 10**12), "highest track"),
        (lambda file: file["tracks"].attrs.__setitem__("run", 7), "began as run 7"),
        (
            lambda file: replaced(file, "tracks/track", data=-file["tracks/track"][()]),
            "ids are positive",
        ),
        (
            lambda file: replaced(file, "edits/id", data=np.array([7, 9])),
            "not numbered from 1",
        ),
    ],
)
def test_what_a_session_never_holds_is_refused(
    copy: Path, spoil: Callable[[h5py.File], object], why: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = spoiled(copy, spoil)
    monkeypatch.setattr("tracking.session.session_reader.check_file", in_this_process)
    refused(path, why)


def in_this_process(path: Path) -> tuple[int, int]:
    try:
        return inspect(path)
    except Refused as why:
        raise SessionError(f"{path} {why}") from why


def test_the_verdict_of_the_other_process_is_told(copy: Path) -> None:
    spoiled(copy, lambda file: file.attrs.__setitem__("format_version", "2.0"))
    refused(copy, "made by a newer trackwright; update to open it")


@pytest.mark.parametrize(
    "spoil",
    [
        lambda file: replaced(
            file, "runs/0/tracks/frame", data=file["runs/0/tracks/frame"][()][::-1]
        ),
        lambda file: file["runs/0"].attrs.__setitem__("frames", [0, 10**12]),
    ],
)
def test_a_run_that_no_tracker_found_is_told_when_it_is_looked_at(
    copy: Path, spoil: Callable[[h5py.File], object]
) -> None:
    session = Session.open(spoiled(copy, spoil))
    with pytest.raises(SessionError, match="damaged"):
        session.runs[0]
    session.close()


def test_particle_offsets_that_fill_the_memory_are_refused(
    copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Whole columns of particles are never read, but their offsets are.
    monkeypatch.setattr(inspection, "_KIND", replace(inspection._KIND, most_bytes=1 << 20))
    inspect(copy)
    offsets = {"data": np.zeros(1 << 20, np.int64), "compression": "gzip"}
    with pytest.raises(Refused, match="more data than any session"):
        inspect(spoiled(copy, lambda file: replaced(file, "runs/0/particles/start", **offsets)))


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such limits there")
def test_a_system_that_refuses_limits_still_looks_files_over(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    import resource

    asked = []

    def refusing(kind: int, _: object) -> None:
        asked.append(kind)
        raise ValueError("current limit exceeds maximum limit")

    monkeypatch.setattr(resource, "setrlimit", refusing)
    limit()
    # One that is refused keeps nobody from asking for the others.
    assert {resource.RLIMIT_AS, resource.RLIMIT_CPU} <= set(asked)


def test_particles_that_do_not_add_up_are_told_when_they_are_looked_at(copy: Path) -> None:
    spoiled(copy, lambda file: file["runs/0/particles/start"].__setitem__(3, 10**9))
    session = Session.open(copy)
    with pytest.raises(SessionError, match="particles of run 0"):
        session.runs[0].particles.of_frame(2)
    session.close()


def test_an_edit_in_the_log_that_is_none_is_told_when_it_is_undone(copy: Path) -> None:
    spoiled(copy, lambda file: file["edits/before"].__setitem__(1, "{"))
    session = Session.open(copy)
    before = state_of(session)
    with pytest.raises(TrackwrightError, match="cannot be read"):
        session.undo()
    assert state_of(session) == before
    session.close()


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such timers there")
def test_a_file_in_which_the_library_loops_is_refused_at_once(copy: Path) -> None:
    loop = (
        "import sys; from tracking.untrusted import say_verdicts\n"
        "def look(path):\n"
        "    while True: pass\n"
        "say_verdicts(look)\n"
    )
    program = copy.with_name("loop.py")
    program.write_text(loop)
    before = resource_seconds()
    assert "cannot be read safely" in verdicts_of(str(program), "session", [copy])[0]["refused"]
    assert resource_seconds() - before < 5


def resource_seconds() -> float:
    """Processor time of all programs that this one waited for."""
    import resource

    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@pytest.mark.skipif(sys.platform != "linux", reason="what is taken is read from /proc")
def test_text_that_a_small_file_multiplies_is_refused(copy: Path) -> None:
    program = copy.with_name("fill.py")
    program.write_text(
        "from tracking.untrusted import say_verdicts\n"
        "say_verdicts(lambda path: len(bytearray(200 << 20)))\n"
    )
    (verdict,) = verdicts_of(str(program), "session", [copy])
    assert verdict == {"refused": " is damaged or cut short", "unreadable": True}


def test_a_manifest_of_many_megabytes_in_a_session_is_refused(
    copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    spoiled(copy, lambda file: replaced(file, "recording/manifest", data="#" * (2 << 20)))
    monkeypatch.setattr("tracking.session.session_reader.check_file", in_this_process)
    refused(copy, "more text at recording/manifest")


def test_spoiled_bytes_never_end_in_anything_but_an_error(
    copy: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracking.session.session_reader.check_file", in_this_process_or_damaged)
    chance, data = random.Random(5), copy.read_bytes()
    opened = 0
    for _ in range(60):
        spoilt = bytearray(data)
        for _ in range(chance.choice((1, 4, 64))):
            spoilt[chance.randrange(len(spoilt))] = chance.randrange(256)
        copy.write_bytes(spoilt)
        try:
            session = Session.open(copy)
            session.runs[0].particles.of_frame(3)
            session.close()
        except TrackwrightError:
            continue
        opened += 1
    assert opened < 60


def in_this_process_or_damaged(path: Path) -> tuple[int, int]:
    try:
        return inspect(path)
    except Exception as why:  # the other process turns whatever comes into a verdict
        raise SessionError(f"{path} is damaged ({why})") from why


def test_a_file_that_a_busy_machine_had_no_time_for_is_not_called_damaged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow = tmp_path / "slow.py"
    slow.write_text("import time\nprint('{\"version\": 1}', flush=True)\ntime.sleep(60)\n")
    monkeypatch.setattr("tracking.untrusted.program.PATIENCE_S", 1.0)
    sound, late = verdicts_of(str(slow), "session", [tmp_path / "one.h5", tmp_path / "other.h5"])
    assert sound == {"version": 1}
    assert "not checked within 1.0 s" in str(late["refused"])
    assert "damaged" not in str(late["refused"])
