"""What an export wrote is known again."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from app.features.files.own_files import is_own, remember


@pytest.mark.skipif(sys.platform != "linux", reason="a file that cannot be read, even by root")
def test_a_file_that_cannot_be_read_is_not_remembered_and_others_are(tmp_path: Path) -> None:
    unreadable, written = Path("/proc/self/mem"), tmp_path / "out.csv"
    written.write_text("1")
    remember([unreadable, written])
    assert is_own(written)
    assert not is_own(unreadable)
