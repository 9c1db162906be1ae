"""What can be dropped on the window, in words, for whoever dropped something else."""

from __future__ import annotations

from app.core.i18n import tr


def no_footage(name: str) -> str:
    """Of a dropped file that is for people to read."""
    return tr(
        "{name} is a text to read. Drop videos of the cameras, a folder with their images, a "
        "recording's folder or recording.toml, a bag, or a session (.h5); tracks of another tool "
        "once their recording is open.",
        name=name,
    )
