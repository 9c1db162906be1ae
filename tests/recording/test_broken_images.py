"""Images that are broken or of another size are told on opening, without decoding all."""

from __future__ import annotations

import os
import struct
import zlib
from pathlib import Path

import cv2
import numpy as np
import pytest
from numbered_videos import numbered_picture
from small_recordings import write_images

from tracking.errors import RecordingError
from tracking.recording import OpenOptions, open_recording
from tracking.recording.image_headers import size_of

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


KINDS = ("png", "jpg", "bmp", "ppm", "tif", "webp")
HUGE = 30_000  # px, a side


@pytest.mark.parametrize("depth", [np.uint8, np.uint16])
@pytest.mark.parametrize("ending", KINDS)
def test_a_file_says_its_size(tmp_path: Path, ending: str, depth: type) -> None:
    if depth is np.uint16 and ending in ("jpg", "bmp", "webp"):
        pytest.skip("has no 16 bits")
    file = tmp_path / f"one.{ending}"
    content = cv2.imencode(f".{ending}", np.zeros((30, 50, 3), depth))[1].tobytes()
    file.write_bytes(content)
    assert size_of(file) == (50, 30)
    file.write_bytes(content[:6])
    assert size_of(file) is None


def test_a_lossy_webp_and_a_jpeg_with_a_long_head_say_their_size(tmp_path: Path) -> None:
    picture = np.zeros((30, 50, 3), np.uint8)
    lossy = cv2.imencode(".webp", picture, [cv2.IMWRITE_WEBP_QUALITY, 80])[1].tobytes()
    (tmp_path / "a.webp").write_bytes(lossy)
    assert size_of(tmp_path / "a.webp") == (50, 30)
    jpeg = cv2.imencode(".jpg", picture)[1].tobytes()
    note = b"\xff\xe1" + (60_000).to_bytes(2, "big") + bytes(59_998)
    (tmp_path / "a.jpg").write_bytes(jpeg[:2] + note + jpeg[2:])
    assert size_of(tmp_path / "a.jpg") == (50, 30)


def of_size(ending: str, side: int) -> bytes:
    """A small picture whose header says that it is of another size."""
    content = bytearray(cv2.imencode(f".{ending}", np.zeros((64, 64, 3), np.uint8))[1].tobytes())
    if ending == "png":
        struct.pack_into(">II", content, 16, side, side)
        struct.pack_into(">I", content, 29, zlib.crc32(content[12:29]))
    elif ending == "jpg":
        struct.pack_into(">HH", content, content.index(b"\xff\xc0") + 5, side, side)
    elif ending == "bmp":
        struct.pack_into("<ii", content, 18, side, side)
    elif ending == "ppm":
        content[:12] = b"P6 %d %d 255\n" % (side, side)
    elif ending == "tif":
        entries = struct.unpack_from("<I", content, 4)[0] + 2
        for at in range(entries, len(content) - 12, 12):
            tag, kind = struct.unpack_from("<HH", content, at)
            if tag in (256, 257) and kind in (3, 4):
                struct.pack_into("<H" if kind == 3 else "<I", content, at + 8, side)
    elif ending == "webp":
        bits = int.from_bytes(content[21:25], "little") >> 28 << 28  # it is lossless
        content[21:25] = (bits | 16382 | 16382 << 14).to_bytes(4, "little")
    return bytes(content)


@pytest.mark.parametrize("ending", KINDS)
def test_an_image_that_says_it_is_huge_is_never_decoded(
    tmp_path: Path, ending: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(3):
        (tmp_path / f"{number}.{ending}").write_bytes(of_size(ending, HUGE))

    def decode(*_: object) -> None:
        raise AssertionError("it is decoded")

    monkeypatch.setattr(cv2, "imdecode", decode)
    with pytest.raises(RecordingError, match=r"has \d{5} x \d{5} px; images of up to 40 Mpx"):
        open_recording(tmp_path, OpenOptions(fps=5))


def test_a_huge_image_among_others_is_told_and_left_out(tmp_path: Path) -> None:
    write_images(tmp_path, range(COUNT))
    (tmp_path / f"{BAD:06d}.png").write_bytes(of_size("png", HUGE))
    assert "1 image broken or of another size, first 000006.png" in notes_of(tmp_path)


def test_a_file_far_larger_than_its_picture_is_never_read(tmp_path: Path) -> None:
    for number in range(3):
        file = tmp_path / f"{number}.png"
        file.write_bytes(of_size("png", 64))
        os.truncate(file, 1 << 30)
    with pytest.raises(RecordingError, match="is far too large for 64 x 64 px"):
        open_recording(tmp_path, OpenOptions(fps=5))
