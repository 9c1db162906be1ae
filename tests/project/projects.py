"""Projects in tests: walks, their sessions, and a reader that is this process."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

from tests.batch.walks import make_walk
from tracking.editing import plan_mark_reviewed
from tracking.pipeline import track
from tracking.project import Project, ProjectList, ProjectRow, ReaderProcess
from tracking.project.fact_reader import read_facts
from tracking.project.readings import ReadFacts, Reading
from tracking.recording import open_recording
from tracking.session import Session

TRACKER = "three-part"


def make_session(recording: Path, path: Path) -> Path:
    """A session of a recording, tracked."""
    with open_recording(recording) as opened, track(opened, TRACKER) as tracking:
        for _ in tracking:
            pass
        Session.create(opened, [tracking.run()], path).close()
    return path


def make_project(folder: Path, names: Sequence[str] = ("a", "b")) -> Path:
    """Recordings with ground truth; the first one has a session beside it."""
    for number, name in enumerate(names):
        make_walk(folder / name, number, truth=True)
    make_session(folder / names[0], folder / f"{names[0]}.h5")
    return folder


def mark_reviewed(path: Path, author: str, start: int = 0, end: int = 12) -> None:
    """Somebody marks frames of a session as reviewed, and saves."""
    with closing(Session.open(path, author=author)) as session:
        session.apply(plan_mark_reviewed(session.labels, 0, start, end))
        session.save()


class ReaderHere(ReaderProcess):
    """Reads in this process, and tells what it was asked."""

    def __init__(self) -> None:
        super().__init__()
        self.asked: list[Path] = []

    def read(self, reading: Reading) -> ReadFacts:
        """See `ReaderProcess`."""
        self.asked.append(reading.path)
        return read_facts(reading)


def read_all(project: Project) -> tuple[ProjectList, list[Path]]:
    """The list once all is read, and the files that were read for it, in order."""
    reader = ReaderHere()
    while (found := project.look()).wanted:
        project.read(found.wanted, reader, lambda *_: None)
        assert len(reader.asked) < 1000
    return found, reader.asked


def rows_of(found: ProjectList) -> dict[str, ProjectRow]:
    """Rows by name."""
    return {row.name: row for row in found.rows}
