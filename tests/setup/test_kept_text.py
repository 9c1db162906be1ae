"""A recording.toml that is written anew reads as the plan says."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracking.geometry import Ground
from tracking.recording import read_manifest
from tracking.setup import plan_of, write_setup

_SOURCES = '\n[left]\nsource = "left/*.png"\n'
_TOPICS = '[left]\nsource = "a.bag"\ntopic = "/l"\n[right]\nsource = "a.bag"\ntopic = "/r"\n'
_GROUND = "\n[ground]\nheight = 2.0\ntilt = 30.0\n"
_DEPTH = '[depth]\nsource = "depth/*.png"\ntopic = "/d"\nscale = 0.01\n'


@pytest.mark.parametrize(
    "old",
    [
        f"{_SOURCES}{_GROUND}{_DEPTH}",
        f"{_TOPICS}{_GROUND}",
        f'left = {{ source = "left/*.png" }}\n{_GROUND}',
        f"ground.height = 2.0\nground.tilt = 30.0\n{_SOURCES}",
        f'["left"]\nsource = "left/*.png"\n{_GROUND}',
    ],
    ids=["depth", "topics", "inline", "dotted", "quoted"],
)
def test_a_recording_set_up_again_is_read_as_before(tmp_path: Path, old: str) -> None:
    (tmp_path / "recording.toml").write_text(old)
    before = read_manifest(tmp_path)
    write_setup(plan_of(tmp_path), replace_old=True)
    write_setup(plan_of(tmp_path), replace_old=True)
    after = read_manifest(tmp_path)
    assert after == before
    assert after.ground == Ground(2.0, 30.0)
