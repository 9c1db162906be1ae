"""Agreement between annotators over all recordings of a project."""

from __future__ import annotations

import math
import shutil
from contextlib import closing
from pathlib import Path

import pytest

from tests.project.projects import make_project, mark_reviewed, read_all
from tracking.editing import plan_delete
from tracking.project import Project, ProjectList
from tracking.project.agreements import PairAgreement, agreements, compared_rows, pooled
from tracking.session import Session


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> ProjectList:
    """Two annotators' sessions of one recording: the other one deletes half of the tracks."""
    folder = make_project(tmp_path_factory.mktemp("agreed") / "walks")
    (folder / "bo").mkdir()
    shutil.copy(folder / "a.h5", folder / "bo" / "a.h5")
    mark_reviewed(folder / "a.h5", "Ada")
    with closing(Session.open(folder / "bo" / "a.h5", author="Bo")) as session:
        (track,) = session.tracks.track_ids
        session.apply(plan_delete(session.tracks, track, 12))
        session.save()
    return read_all(Project(folder, folder.parent / "cache", "Ada"))[0]


def test_each_two_sessions_of_a_recording_are_compared(found: ProjectList) -> None:
    assert [row.name for row in compared_rows(found.rows)] == ["a"]
    steps: list[tuple[int, int]] = []
    (pair,) = agreements(found.rows, lambda *step: steps.append(step))
    assert (pair.recording, pair.a, pair.b, pair.problem) == ("a", "Ada", "Bo", "")
    assert steps == [(0, 1), (1, 1)]
    assert 0.5 < pair.idf1 < 0.9
    assert pair.disagreements == 1
    assert pooled([pair]) == PairAgreement(
        "", "", "", pair.idf1, pair.kappa, pair.rows, pair.disagreements
    )


def test_two_sessions_of_one_person_are_told_by_name_and_file(tmp_path: Path) -> None:
    folder = make_project(tmp_path / "walks")
    (folder / "again").mkdir()
    mark_reviewed(folder / "a.h5", "Ada")
    shutil.copy(folder / "a.h5", folder / "again" / "a.h5")
    rows = read_all(Project(folder, tmp_path / "cache", "Ada"))[0].rows
    (pair,) = agreements(rows)
    assert (pair.a, pair.b) == ("Ada (walks/a.h5)", "Ada (again/a.h5)")


def test_a_session_that_cannot_be_read_any_more_is_told(found: ProjectList, tmp_path: Path) -> None:
    kept = tmp_path / "kept.h5"
    row = compared_rows(found.rows)[0]
    session = row.sessions[1].path
    shutil.move(session, kept)
    try:
        (pair,) = agreements(found.rows)
    finally:
        shutil.move(kept, session)
    assert str(pair.problem)
    assert math.isnan(pair.idf1)


def test_pairs_count_by_their_rows_and_empty_ones_not_at_all() -> None:
    pairs = [
        PairAgreement("a", "Ada", "Bo", 1.0, 1.0, 300, 0),
        PairAgreement("b", "Ada", "Bo", 0.6, 0.2, 100, 4),
        PairAgreement("c", "Ada", "Bo"),
    ]
    whole = pooled(pairs)
    assert (whole.idf1, whole.kappa) == pytest.approx((0.9, 0.8))
    assert (whole.rows, whole.disagreements) == (400, 4)
    assert math.isnan(pooled([]).kappa)
