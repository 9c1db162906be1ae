"""Work that was never saved is looked for, never at the cost of the recording itself."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from app.core.document import document_loader
from app.features.files import left_behind
from tracking.editing import plan_rename
from tracking.errors import CancelledError
from tracking.progress import no_progress
from tracking.recording import Recording, open_recording
from tracking.session import Session


@pytest.fixture
def left(tiny_recording: Path, tiny_session: Path) -> Callable[[int], Path]:
    """Puts a session of the recording among those that were never saved."""

    def put(number: int) -> Path:
        path = document_loader.unsaved_folder() / f"{tiny_recording.stem}-{number}.h5"
        path.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(tiny_session, path)
        return path

    return put


def test_a_file_that_goes_while_it_is_looked_at_hides_no_other(
    tiny_recording: Path, left: Callable[[int], Path]
) -> None:
    path = left(2)
    (path.parent / f"{tiny_recording.stem}-1.h5").symlink_to(path.parent / "gone.h5")
    opened = left_behind.open_with_unsaved(tiny_recording, None, None, no_progress)
    assert opened.unsaved == path
    opened.close()


def test_of_two_the_one_that_was_edited_last_is_offered_not_the_one_tracked_last(
    tiny_recording: Path, left: Callable[[int], Path]
) -> None:
    edited, tracked = left(1), left(2)
    session = Session.open(edited)
    session.apply(
        plan_rename(session.tracks, session.labels, session.tracks.track_ids[0], "red coat")
    )
    session.close()
    for path, at_s in ((edited, 100), (tracked, 200)):
        os.utime(path, (at_s, at_s))
    opened = left_behind.open_with_unsaved(tiny_recording, None, None, no_progress)
    assert opened.unsaved == edited
    opened.close()


def test_sources_that_cannot_be_compared_open_all_the_same(
    tiny_recording: Path, left: Callable[[int], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    left(1)

    def refuse(_: Recording) -> None:
        raise PermissionError("not yours")

    monkeypatch.setattr(Recording, "fingerprints", refuse)
    opened = left_behind.open_with_unsaved(tiny_recording, None, None, no_progress)
    assert opened.unsaved is None
    opened.close()


def test_cancel_counts_until_the_last_file_was_looked_into(
    tiny_recording: Path, left: Callable[[int], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    left(1)
    looked: list[Path] = []
    closed: list[Recording] = []
    look, close = left_behind.recording_of, Recording.close
    monkeypatch.setattr(left_behind, "recording_of", lambda one: looked.append(one) or look(one))
    monkeypatch.setattr(Recording, "close", lambda one: closed.append(one) or close(one))

    def cancel(_done: int, _total: int) -> None:
        if looked:
            raise CancelledError("stopped by the user")

    with pytest.raises(CancelledError):
        left_behind.open_with_unsaved(tiny_recording, None, None, cancel)
    assert len(closed) == 1


def test_work_that_is_open_right_now_is_not_offered(
    tiny_recording: Path, left: Callable[[int], Path]
) -> None:
    older = left(1)
    with open_recording(tiny_recording) as recording:
        session = document_loader.session_by_hand(recording)
        assert left_behind.find_left_behind(recording, no_progress) == older
        session.close()
        assert left_behind.find_left_behind(recording, no_progress) == session.path
