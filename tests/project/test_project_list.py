"""What a project's list says of recordings and sessions, and what is read for it again."""

from __future__ import annotations

import shutil
from contextlib import closing
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.batch.batches import batch
from tests.batch.walks import FRAMES, make_damaged, make_walk
from tests.project.projects import make_project, make_session, mark_reviewed, read_all, rows_of
from tracking.editing import plan_mark_reviewed
from tracking.project import Project, next_to_review
from tracking.recording import open_recording
from tracking.session import Session
from tracking.synthesis.video import CLIP_COMMENT, VideoWriter


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two recordings with ground truth, one of them tracked; not to be changed."""
    return make_project(tmp_path_factory.mktemp("template") / "walks")


@pytest.fixture
def folder(template: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copytree(template, tmp_path / "walks"))


@pytest.fixture
def project(folder: Path, tmp_path: Path) -> Project:
    """The project on it."""
    return Project(folder, tmp_path / "cache", "Ada")


def test_the_list_says_what_is_known_of_each(project: Project) -> None:
    found, _ = read_all(project)
    a, b = found.rows
    assert (a.name, b.name) == ("a", "b")
    assert a.facts is not None
    assert (a.facts.frames, a.facts.length_s, a.facts.has_truth) == (FRAMES, FRAMES / 10, True)
    assert a.session is not None
    facts = a.session.facts
    assert facts is not None
    assert (facts.people, facts.tracker, facts.edits) == (1, "three-part", 0)
    assert facts.idf1 is not None
    assert facts.idf1 > 0.8
    assert not b.sessions
    assert (a.problem, b.problem) == ("", "")
    for row in found.rows:
        image = cv2.imdecode(np.frombuffer(project.image(row), np.uint8), cv2.IMREAD_COLOR)
        assert image is not None


def test_a_clip_that_was_exported_beside_them_is_no_recording(
    project: Project, folder: Path
) -> None:
    for name, comment in (("clip.mp4", CLIP_COMMENT), ("other.mp4", "")):
        with VideoWriter(folder / name, (64, 48), 10.0, comment) as writer:
            for _ in range(12):
                writer.write(np.full((48, 64, 3), 90, np.uint8))
    found, _ = read_all(project)
    names = set(rows_of(found))
    assert "other.mp4" in names
    assert "clip.mp4" not in names


def test_what_did_not_change_is_not_read_again(project: Project, folder: Path) -> None:
    found, asked = read_all(project)
    assert sorted(path.name for path in asked) == ["a", "a.h5", "b"]
    again, asked = read_all(Project(folder, folder.parent / "cache"))
    assert asked == []
    assert [row.facts for row in again.rows] == [row.facts for row in found.rows]


def test_a_session_that_was_edited_is_read_again_and_nothing_else(
    project: Project, folder: Path
) -> None:
    read_all(project)
    mark_reviewed(folder / "a.h5", "Ada", 0, FRAMES)
    found, asked = read_all(project)
    assert asked == [folder / "a.h5"]
    session = rows_of(found)["a"].session
    assert session is not None
    assert session.facts is not None
    assert (session.facts.reviewed_rows, session.facts.authors) == (1.0, ("Ada",))
    assert session.facts.items_left == 0


def test_edits_that_wait_in_the_journal_count(project: Project, folder: Path) -> None:
    read_all(project)
    with closing(Session.open(folder / "a.h5", author="Bo")) as session:
        session.apply(plan_mark_reviewed(session.labels, 0, 0, FRAMES))
        found, _ = read_all(project)
        shown = rows_of(found)["a"].session
        assert shown is not None
        assert shown.facts is not None
        assert shown.facts.authors == ("Bo",)
        assert shown.holder == "this window"
    found, _ = read_all(project)
    shown = rows_of(found)["a"].session
    assert shown is not None
    assert shown.holder == ""


def test_ground_truth_that_changes_scores_the_session_again(project: Project, folder: Path) -> None:
    read_all(project)
    (folder / "a" / "truth.txt").write_text("no rows\n")
    found, asked = read_all(project)
    assert set(asked) == {folder / "a", folder / "a.h5"}
    session = rows_of(found)["a"].session
    assert session is not None
    assert session.facts is not None
    assert session.facts.idf1 is None
    assert session.facts.not_scored


def test_several_sessions_of_a_recording_are_one_row_with_your_own_first(
    project: Project, folder: Path
) -> None:
    (folder / "bo").mkdir()
    with closing(Session.open(folder / "a.h5")) as session:
        session.save(folder / "bo" / "a.h5")
    make_session(folder / "b", folder / "b" / "b.h5")
    mark_reviewed(folder / "a.h5", "Ada")
    mark_reviewed(folder / "bo" / "a.h5", "Bo")
    found, _ = read_all(project)
    rows = rows_of(found)
    assert list(rows) == ["a", "b"]
    assert [one.path for one in rows["a"].sessions] == [folder / "a.h5", folder / "bo" / "a.h5"]
    assert rows["b"].path == folder / "b" / "b.h5"
    other, _ = read_all(Project(folder, folder.parent / "cache", "Bo"))
    assert rows_of(other)["a"].path == folder / "bo" / "a.h5"


def test_a_session_that_was_moved_away_is_known_by_the_images(
    project: Project, folder: Path
) -> None:
    (folder / "sessions" / "of" / "May").mkdir(parents=True)
    (folder / "a.h5").rename(folder / "sessions" / "of" / "May" / "first.h5")
    found, _ = read_all(project)
    rows = rows_of(found)
    assert list(rows) == ["a", "b"]
    assert rows["a"].path.name == "first.h5"
    session = rows["a"].session
    assert session is not None
    assert session.facts is not None
    assert session.facts.idf1 is not None


def test_a_session_whose_recording_is_elsewhere_is_a_row_of_its_own(
    project: Project, folder: Path
) -> None:
    shutil.move(folder / "a", folder.parent / "gone")
    found, _ = read_all(project)
    rows = rows_of(found)
    assert list(rows) == ["a.h5", "b"]
    assert rows["a.h5"].recording is None
    assert rows["a.h5"].path == folder / "a.h5"
    session = rows["a.h5"].session
    assert session is not None
    assert session.facts is not None
    assert session.facts.name == "a"


def test_a_session_of_other_images_says_so(project: Project, folder: Path) -> None:
    shutil.rmtree(folder / "a")
    make_walk(folder / "a", 5)
    found, _ = read_all(project)
    session = rows_of(found)["a"].session
    assert session is not None
    assert str(session.note) == "the images are not those that the session was made of"


@pytest.mark.parametrize("kind", range(5))
def test_a_damaged_recording_is_a_row_with_a_reason(
    project: Project, folder: Path, kind: int
) -> None:
    make_damaged(folder / "c", kind)
    found, asked = read_all(project)
    assert str(rows_of(found)["c"].problem)
    assert folder / "c" in asked
    _, asked = read_all(project)
    assert asked == []


@pytest.mark.parametrize("content", [b"", b"no session", b"\x89HDF\r\n\x1a\n and no more"])
def test_a_damaged_session_is_told_at_its_recording(
    project: Project, folder: Path, content: bytes
) -> None:
    (folder / "b" / "b.h5").write_bytes(content)
    found, _ = read_all(project)
    row = rows_of(found)["b"]
    assert str(row.problem).startswith("b.h5: ")
    assert row.path == folder / "b"


def test_a_batch_tells_what_became_of_each(project: Project, folder: Path) -> None:
    make_damaged(folder / "c", 1)
    (folder / "results").mkdir()
    batch(folder / "results", [folder / name for name in "abc"])
    found, _ = read_all(project)
    rows = rows_of(found)
    assert [row.batch is not None and row.batch.is_done for row in found.rows] == [
        True,
        True,
        False,
    ]
    assert str(rows["c"].problem)
    assert rows["b"].path == folder / "results" / "b.h5"
    assert found.batches == (folder / "results",)


def test_a_ledger_that_is_none_is_told_and_the_rest_is_listed(
    project: Project, folder: Path
) -> None:
    (folder / "batch.sqlite").write_bytes(b"no database, but long enough to be looked at")
    found, _ = read_all(project)
    assert len(found.rows) == 2
    assert "batch.sqlite" in str(found.notes[0])


def test_what_is_kept_may_be_damaged(project: Project, folder: Path, tmp_path: Path) -> None:
    read_all(project)
    (tmp_path / "cache" / "project.sqlite").write_bytes(b"x" * 5000)
    found, asked = read_all(project)
    assert len(asked) == 3
    assert [row.is_read for row in found.rows] == [True, True]


def test_a_hand_made_session_has_nothing_to_review(project: Project, folder: Path) -> None:
    with open_recording(folder / "b") as recording:
        Session.create(recording, [], folder / "b.h5").close()
    found, _ = read_all(project)
    session = rows_of(found)["b"].session
    assert session is not None
    assert session.facts is not None
    assert session.facts.hand_made
    assert session.facts.decided_share is None
    assert session.facts.errors is None
    assert next_to_review([rows_of(found)["b"]]) is None


def test_what_cannot_be_kept_is_read_once_all_the_same(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "cache").write_text("no folder")
    project = Project(folder, tmp_path / "cache")
    _, asked = read_all(project)
    assert len(asked) == 3
    _, asked = read_all(project)
    assert asked == []
