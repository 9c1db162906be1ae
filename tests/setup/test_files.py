"""What in a folder may be cameras, and what of it cannot be read."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tracking.errors import RecordingError
from tracking.recording.kinds import bag
from tracking.setup.files import may_be_camera, needs_setup, sources_in


@pytest.fixture
def locked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder that nobody may list; by rights alone the superuser could."""
    folder, listed = tmp_path / "locked", Path.iterdir
    folder.mkdir()

    def refuse(path: Path) -> Iterator[Path]:
        if path == folder:
            raise PermissionError(13, "Permission denied", str(path))
        return listed(path)

    monkeypatch.setattr(Path, "iterdir", refuse)
    return folder


def test_a_folder_that_cannot_be_read_is_no_camera(locked: Path) -> None:
    assert not may_be_camera(locked)
    assert not needs_setup(locked)
    with pytest.raises(RecordingError, match="cannot be read"):
        sources_in(locked)


def test_videos_beside_a_folder_that_cannot_be_read_are_found(locked: Path) -> None:
    images = locked.parent / "camera"
    images.mkdir()
    (images / "0.png").touch()
    assert sources_in(locked.parent) == (images,)
    assert needs_setup(locked.parent)


def test_no_program_reads_a_bag_to_tell_whether_it_is_to_be_set_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(path: Path) -> None:
        raise AssertionError(f"{path} was opened")

    monkeypatch.setattr(bag, "open_bag", refuse)
    (tmp_path / "metadata.yaml").write_text("rosbag2_bagfile_information:\n  version: 5\n")
    (tmp_path / "preview.mp4").touch()
    assert needs_setup(tmp_path)
    (tmp_path / "run.db3").touch()
    assert not needs_setup(tmp_path)
