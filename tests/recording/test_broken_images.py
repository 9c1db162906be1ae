"""Images that are broken or of another size are told on opening, without decoding all."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from numbered_videos import numbered_picture
from small_recordings import write_images

from tracking.recording import OpenOptions, open_recording
from tracking.recording.image_headers import size_in

COUNT = 20
BAD = 6  # none of the few images that opening decodes


def notes_of(folder: Path) -> str:
    with open_recording(folder, OpenOptions(fps=5)) as recording:
        return "; ".join(recording.notes)


@pytest.mark.parametrize("content", [b"", b"junk" * 50])
def test_a_file_that_is_no_image_is_told_on_opening(tmp_path: Path, content: bytes) -> None:
    write_images(tmp_path, range(COUNT))
    (tmp_path / f"{BAD:06d}.png").write_bytes(content)
    assert "1 image broken or of another size, first 000006.png" in notes_of(tmp_path)


@pytest.mark.parametrize("ending", ["png", "jpg"])
def test_an_image_of_another_size_is_told_on_opening(tmp_path: Path, ending: str) -> None:
    for number in range(COUNT):
        picture = numbered_picture(number)
        if number == BAD:
            picture = np.asarray(cv2.resize(picture, None, fx=2, fy=2), np.uint8)
        cv2.imwrite(str(tmp_path / f"{number:03d}.{ending}"), picture)
    assert f"1 image broken or of another size, first 006.{ending}" in notes_of(tmp_path)


@pytest.mark.parametrize("ending", ["png", "jpg", "bmp", "ppm", "tif", "webp"])
def test_good_images_of_any_kind_give_no_note(tmp_path: Path, ending: str) -> None:
    for number in range(COUNT):
        cv2.imwrite(str(tmp_path / f"{number:03d}.{ending}"), numbered_picture(number))
    assert notes_of(tmp_path) == ""


@pytest.mark.parametrize("ending", [".png", ".jpg"])
def test_first_bytes_say_the_size(ending: str) -> None:
    content = cv2.imencode(ending, np.zeros((30, 50, 3), np.uint8))[1].tobytes()
    assert size_in(content) == (50, 30)
    assert size_in(content[:12]) is None
