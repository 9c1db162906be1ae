"""A session made of imported tracks: what its run and its first edit are called."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from tests.session.small_footage import write_footage
from tracking.formats import format_of
from tracking.recording import open_recording
from tracking.session import (
    ImportOrigin,
    ImportWish,
    Session,
    describe_footage,
    fit_to_recording,
    session_of_import,
)

TRACKS = "".join(f"{frame},1,{frame},2,8,16,1,-1,-1,-1\n" for frame in (1, 2, 3))
"""Of three frames, so that the middle one can be left out."""


def imported(folder: Path, wish: ImportWish) -> Session:
    source = folder / "truth.txt"
    source.write_text(f"{TRACKS}1,2,20,2,8,16,1,-1,-1,-1\n", encoding="utf-8")
    with open_recording(write_footage(folder / "hall")) as recording:
        filmed = describe_footage(recording)
        read = format_of(source).read
        assert read is not None
        found = fit_to_recording(read(source, filmed), filmed, wish)
        return session_of_import(recording, found, ImportOrigin.of(source, "mot"))


def test_thinned_tracks_are_a_run_whose_edit_says_that_it_made_keyframes(tmp_path: Path) -> None:
    with closing(imported(tmp_path, ImportWish(thin_px=2.0))) as session:
        (entry,) = session.history
        assert str(entry.change.text) == "Make keyframes of 1 and 2"
        session.undo()
        assert session.tracks.track_ids == (1, 2)
