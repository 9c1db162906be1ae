"""A session and its journal as the last version before 1.6 left them read and score as they did.

`tests/golden/session/before-messages.*`: the file, the statements that make its journal, and what
that version printed of both.
"""

from __future__ import annotations

import gzip
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.session import Session
from tracking.session.session_writer import companions

GOLDEN = Path(__file__).parents[2] / "golden" / "session"


def golden(ending: str) -> Path:
    return GOLDEN / f"before-messages.{ending}"


@pytest.fixture
def former(tmp_path: Path) -> Path:
    """The session with the edits that wait in its journal."""
    path = tmp_path / "s.h5"
    path.write_bytes(gzip.decompress(golden("h5.gz").read_bytes()))
    beside = companions(path)
    beside.mkdir(mode=0o700)
    with closing(sqlite3.connect(beside / "journal.sqlite")) as journal:
        journal.executescript(golden("journal.sql").read_text())
    (beside / "journal.sqlite").chmod(0o600)
    return path


def test_its_log_is_told_to_the_byte(
    trackwright: Trackwright, former: Path, tmp_path: Path
) -> None:
    assert trackwright("log", former)[1] == golden("log.txt").read_text()
    assert trackwright("log", former, "--json")[1] == golden("log.json").read_text()
    trackwright("log", former, "--csv", tmp_path / "log.csv")
    assert (tmp_path / "log.csv").read_bytes() == golden("log.csv").read_bytes()


def test_it_scores_to_the_byte(trackwright: Trackwright, former: Path, tmp_path: Path) -> None:
    truth = tmp_path / "truth.txt"
    assert trackwright("export", former, "-o", truth, "--format", "mot", "--run", "0")[0] == 0
    assert trackwright("score", former, "--truth", truth, "--json")[1] == golden(
        "score.json"
    ).read_text().replace("FOLDER", str(tmp_path))


def test_its_waiting_edits_are_made_and_saved(former: Path, trackwright: Trackwright) -> None:
    with closing(Session.open(former)) as session:
        assert session.recovered == 3
        session.save()
    assert trackwright("log", former)[1] == golden("log.txt").read_text()
