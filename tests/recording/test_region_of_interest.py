"""[region] of recording.toml: read, drawn, refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from small_recordings import write_images

from tracking.errors import RecordingError
from tracking.recording import OpenOptions, open_recording, parse_manifest
from tracking.recording.region_of_interest import EVERYWHERE, RegionOfInterest

SIZE = (64, 48)
LEFT_HALF = ((0.0, 0.0), (31.0, 0.0), (31.0, 47.0), (0.0, 47.0))
CORNER = ((0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0))
HEAD = 'fps = 10.0\n[left]\nsource = "*.png"\n'


def region_of(text: str) -> RegionOfInterest:
    return parse_manifest(f"{HEAD}[region]\n{text}", "recording.toml", "folder").region


def test_without_a_region_people_are_looked_for_everywhere() -> None:
    assert region_of("") == EVERYWHERE
    assert EVERYWHERE.pixels(SIZE) is None


def test_one_polygon_or_a_list_of_them_may_be_given() -> None:
    one = region_of("look = [[0, 0], [31, 0], [31, 47], [0, 47]]")
    listed = region_of("look = [[[0, 0], [31, 0], [31, 47], [0, 47]]]\nmask = []")
    assert one == listed == RegionOfInterest(look=(LEFT_HALF,))


def test_the_contracts_region_is_read() -> None:
    region = region_of("look = [[0, 200], [640, 200], [640, 480], [0, 480]]\nmask = []")
    looked_at = region.pixels((640, 480))
    assert looked_at is not None
    assert not looked_at[:200].any()
    assert (looked_at[200:] == 255).all()


def test_masks_are_cut_out_of_what_is_looked_at() -> None:
    looked_at = RegionOfInterest((LEFT_HALF,), (CORNER,)).pixels(SIZE)
    assert looked_at is not None
    assert looked_at.shape == SIZE[::-1]
    assert np.count_nonzero(looked_at) == 32 * 48 - 10 * 10
    assert looked_at[20, 20] == 255
    assert not looked_at[5, 5]
    assert not looked_at[20, 40]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("look = 3", "look must be a list"),
        ("look = [[0, 0], [9, 9]]", "look has a polygon of fewer than three corners"),
        ("mask = [[[0, 0], [9, 9], [0]]]", "mask must be a polygon such as"),
        ("look = [[0, 0], [9, nan], [3, 4]]", "look has a corner farther off"),
        ("look = [[0, 0], [9, 1e9], [3, 4]]", "look has a corner farther off"),
        (f"look = [[0, 0], [{'9' * 400}, 1], [3, 4]]", "look has a corner farther off"),
        (f"look = {[[1, 2]] * 2001}", "look has more than 2000 corners"),
    ],
)
def test_what_is_no_region_is_refused(text: str, problem: str) -> None:
    with pytest.raises(RecordingError, match=rf"recording.toml: \[region\] {problem}"):
        region_of(text)


def test_a_region_outside_of_the_picture_is_refused(tmp_path: Path) -> None:
    write_images(tmp_path, range(3))
    (tmp_path / "recording.toml").write_text(
        HEAD + "[region]\nlook = [[900, 0], [950, 0], [950, 9]]\n"
    )
    with pytest.raises(RecordingError, match="leaves nothing of the picture"):
        open_recording(tmp_path)


def test_options_stand_in_place_of_what_the_recording_says(tmp_path: Path) -> None:
    write_images(tmp_path, range(3))
    (tmp_path / "recording.toml").write_text(
        HEAD + "[region]\nlook = [[0, 0], [50, 0], [50, 9]]\nmask = [[0, 0], [5, 0], [5, 5]]\n"
    )
    with open_recording(tmp_path, OpenOptions(look=(LEFT_HALF,))) as recording:
        assert recording.looked_at is not None
        assert recording.looked_at[40, 20] == 255
        assert not recording.looked_at[1, 3]
        again = parse_manifest(recording.manifest_text, "its manifest", "folder")
    assert again.region.look == (LEFT_HALF,)
    assert len(again.region.mask) == 1
