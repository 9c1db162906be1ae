"""Fixtures of the session's tests."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from made_up_sessions import make_session

from tracking.session import Session, session_reader
from tracking.session.inspection import inspect
from tracking.untrusted import verdict_by


@pytest.fixture(autouse=True)
def look_over(monkeypatch: pytest.MonkeyPatch) -> None:
    """Look all files over, in this process: the same check, without waiting for another Python."""
    monkeypatch.setattr(session_reader, "is_sealed", lambda _: False)
    monkeypatch.setattr(
        session_reader, "inspect_files", lambda paths: [verdict_by(inspect, path) for path in paths]
    )


@pytest.fixture
def session(tmp_path: Path) -> Iterator[Session]:
    """A saved session, open for writing."""
    made = make_session(tmp_path)
    yield made
    made.close()
