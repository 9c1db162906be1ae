"""Bags and tars are set up as they say themselves what they hold."""

from __future__ import annotations

from pathlib import Path

import pytest
from containers_of_scene import Footage, footage_of_scene, write_mcap, write_oak_tar

from tracking.recording import OpenOptions, open_recording
from tracking.setup import find_cameras, write_setup
from tracking.setup.plan import plan_of_container


@pytest.fixture(scope="module")
def scene() -> Footage:
    return footage_of_scene()


@pytest.mark.parametrize("write", [write_mcap, write_oak_tar])
def test_a_container_becomes_a_recording_that_opens(
    write: object, tmp_path: Path, scene: Footage
) -> None:
    path = write(tmp_path, scene)  # type: ignore[operator]
    found = find_cameras(path, None)
    assert (found.left, found.right) == (path, path)
    plan = plan_of_container(path, OpenOptions(fps=10.0))
    written = write_setup(plan)
    with open_recording(written.parent) as opened, open_recording(path, OpenOptions()) as bare:
        assert opened.is_stereo
        assert opened.frame_count == bare.frame_count
        assert (opened.read(1).left == bare.read(1).left).all()
