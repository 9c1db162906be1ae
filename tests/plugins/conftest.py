"""A folder that packages of plug-ins are installed in, seen by this process and its children."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tracking.plugins import offers
from tracking.synthesis import render_recording


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Empty; what a test puts there is offered from then on, see `seen_anew`."""
    folder = tmp_path / "site"
    folder.mkdir()
    monkeypatch.syspath_prepend(str(folder))
    monkeypatch.setenv("PYTHONPATH", str(folder))
    before = set(sys.modules)
    offers.look_again()
    yield folder
    for name in set(sys.modules) - before:
        if str(folder) in str(getattr(sys.modules[name], "__file__", "")):
            del sys.modules[name]
    monkeypatch.undo()
    importlib.invalidate_caches()
    offers.look_again()


@pytest.fixture(scope="session")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A few seconds of three people before one camera."""
    folder = tmp_path_factory.mktemp("clips") / "clip"
    render_recording(folder, "plaza", 4.0, 3, 5, size=(320, 240), fps=8.0, cameras=1)
    return folder
