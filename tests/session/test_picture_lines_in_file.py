"""Lines and regions in the picture come back from file and journal, those of older files too."""

from __future__ import annotations

from pathlib import Path

import h5py
from made_up_sessions import make_session

from tracking.editing import plan_lines, plan_regions
from tracking.session import Session
from tracking.tracks import CountingLine, Region

CORNERS = ((0.0, 0.5), (40.0, 0.5), (40.0, 30.0))
LINES = (
    CountingLine("door", (0.5, 0.0), (3.0, 0.0)),
    CountingLine("gate", (10.0, 20.0), (60.0, 20.0), in_picture=True),
)
REGIONS = (Region("hall", CORNERS), Region("shelf", CORNERS, in_picture=True))


def drawn(folder: Path) -> Session:
    session = make_session(folder)
    session.apply(plan_lines(session.labels, LINES))
    session.apply(plan_regions(session.labels, REGIONS))
    return session


def reopened(session: Session, *, save: bool) -> Session:
    path = session.save() if save else session.path
    assert path is not None
    session.close()
    return Session.open(path)


def test_they_come_back_from_the_file(tmp_path: Path) -> None:
    session = reopened(drawn(tmp_path), save=True)
    assert (session.labels.lines, session.labels.regions) == (LINES, REGIONS)
    session.undo()
    assert session.labels.regions == ()
    session.close()


def test_they_come_back_from_the_journal(tmp_path: Path) -> None:
    session = reopened(drawn(tmp_path), save=False)
    assert (session.labels.lines, session.labels.regions) == (LINES, REGIONS)
    session.close()


def test_older_files_have_all_of_them_on_the_floor(tmp_path: Path) -> None:
    session = drawn(tmp_path)
    path = session.save()
    session.close()
    with h5py.File(path, "r+") as file:
        del file["labels/lines/in_picture"], file["labels/regions/in_picture"]
    older = Session.open(path)
    assert [line.in_picture for line in older.labels.lines] == [False, False]
    assert [region.in_picture for region in older.labels.regions] == [False, False]
    older.close()
