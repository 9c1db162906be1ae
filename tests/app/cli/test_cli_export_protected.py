"""What an export never replaces, even with --force: a recording's own files, a session's own."""

from __future__ import annotations

from pathlib import Path

import pytest
from command_line import Trackwright

from app.features.files.export import refuse_to_lose
from tracking.errors import OutputError

MANIFEST = """
[left]
source = "left/*.pgm"
[right]
source = "right"
[calibration]
file = ["intrinsics.yml", "poses/extrinsics.yml"]
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Of a recording; all its files are text."""
    folder = tmp_path / "walk"
    for name in (
        *("truth.txt", "truth_parts.csv", "intrinsics.yml", "poses/extrinsics.yml"),
        *("left/000.pgm", "right/000.pgm", "notes.txt", "right/notes.txt"),
    ):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("precious\n")
    (folder / "recording.toml").write_text(MANIFEST)
    return folder


@pytest.mark.parametrize(
    "name",
    [
        *("recording.toml", "truth.txt", "truth_parts.csv", "intrinsics.yml"),
        *("poses/extrinsics.yml", "left/000.pgm", "right/000.pgm", "../walk/truth.txt"),
    ],
)
@pytest.mark.parametrize(
    "words",
    [
        ("export", "-o", "--format", "mot", "--force"),
        ("export", "-o", "--format", "mot"),
        ("log", "--csv"),
    ],
)
def test_a_recording_s_own_file_is_never_replaced(
    trackwright: Trackwright, session: Path, folder: Path, name: str, words: tuple[str, ...]
) -> None:
    place = folder / name
    before = place.read_text()
    command, option, *others = words
    status, out, err = trackwright(command, session, option, place, *others)
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert (
        f"is part of the recording walk and would be lost; choose another name with {option}" in err
    )
    assert place.read_text() == before
    with pytest.raises(OutputError, match="part of the recording walk and would be lost"):
        refuse_to_lose(place)


@pytest.mark.parametrize("name", ["notes.txt", "right/notes.txt"])
def test_other_text_beside_a_recording_is_replaced_with_force(
    trackwright: Trackwright, session: Path, folder: Path, name: str
) -> None:
    words = ("export", session, "-o", folder / name, "--format", "mot", "--force")
    assert trackwright(*words)[0] == 0
    assert "precious" not in (folder / name).read_text()


def test_a_ground_truth_that_export_wrote_is_written_again(
    trackwright: Trackwright, session: Path, folder: Path
) -> None:
    (folder / "truth.txt").unlink()
    words = ("export", session, "-o", folder / "truth.txt", "--format", "mot")
    assert [trackwright(*words)[0] for _ in range(2)] == [0, 0]


def test_what_a_session_keeps_beside_it_is_never_replaced(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    kept = tmp_path / ".walk.h5.trackwright"
    kept.mkdir(exist_ok=True)
    (kept / "lock").write_text("1\n")
    words = ("export", session, "-o", kept / "lock", "--format", "csv", "--force")
    status, out, err = trackwright(*words)
    assert (status, out) == (1, "")
    assert "is a file that a session keeps beside it and would be lost" in err
    assert (kept / "lock").read_text() == "1\n"
