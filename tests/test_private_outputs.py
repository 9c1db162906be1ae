"""An output file that replaces a private one is private from its first byte on."""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

import pytest

from tracking.atomic_output import part_of
from tracking.errors import OutputError

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="it has no such permissions")


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


@pytest.mark.parametrize("before", [0o600, 0o644, None])
def test_nobody_else_reads_an_output_while_it_is_written(
    tmp_path: Path, before: int | None
) -> None:
    path = tmp_path / "out.csv"
    if before is not None:
        path.touch()
        path.chmod(before)
    mask = os.umask(0o022)
    try:
        with part_of(path) as part:
            assert mode(part) == 0o600
    finally:
        os.umask(mask)
    assert mode(path) == (0o644 if before is None else before)


def test_an_output_whose_permissions_cannot_be_set_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "out.csv"
    path.write_text("old")

    def refuses(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(Path, "chmod", refuses)
    with pytest.raises(OutputError, match="not permitted"), part_of(path) as part:
        part.write_text("new")
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]
