"""Many places of a bag, read at once."""

from __future__ import annotations

from pathlib import Path

from tracking.recording.bags.container import read_at, read_places


def test_places_are_read_in_the_order_they_are_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "bytes"
    path.write_bytes(bytes(range(200)))
    with path.open("rb") as file:
        file.read(10)  # what is buffered, or where the file stands, does not matter
        assert read_places(file, [150, 3, 150], 2) == [b"\x96\x97", b"\x03\x04", b"\x96\x97"]


def test_a_place_past_the_end_gives_what_is_there(tmp_path: Path) -> None:
    path = tmp_path / "bytes"
    path.write_bytes(b"abc")
    with path.open("rb") as file:
        assert read_places(file, [1, 10**12], 16) == [b"bc", b""]
        assert read_at(file, 2, 16) == b"c"
