"""Paths as users give them."""

from __future__ import annotations

import os
from pathlib import Path

AnyPath = str | os.PathLike[str]


def as_path(path: AnyPath) -> Path:
    """A path; `~` is the user's folder."""
    return Path(path).expanduser()
