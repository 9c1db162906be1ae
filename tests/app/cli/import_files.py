"""Files of tracks that commands import."""

from __future__ import annotations

from pathlib import Path

BOX = ("left", "top", "width", "height")
GOOD = "1,1,10,10,20,40,1\n2,1,11,10,20,40,1\n3,1,12,10,20,40,1\n"
"""MOT text of one person in frames 0 to 2."""


def written(folder: Path, text: str, name: str = "tracks.txt") -> Path:
    """A file of the text."""
    path = folder / name
    path.write_text(text)
    return path
