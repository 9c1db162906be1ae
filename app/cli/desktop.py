"""`desktop`: the menu entry, the icon and the type of sessions, for the user of this computer."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import resources
from app.cli.output import print_json, print_line, say
from tracking.atomic_output import replace_with
from tracking.errors import OutputError
from tracking.translation import msg

_OWN = Path(resources.__file__).parent
FILES: Mapping[str, str] = {
    "applications/trackwright.desktop": "desktop/trackwright.desktop",
    "mime/packages/trackwright.xml": "desktop/trackwright.xml",
    "icons/hicolor/scalable/apps/trackwright.svg": "icons/trackwright.svg",
}
"""Where each file goes below the user's data folder, and where it stands in the resources."""
_REFRESH = (
    ("update-mime-database", "mime"),
    ("update-desktop-database", "applications"),
)
_PATIENCE_S = 60.0


def run_desktop(*, remove: bool, as_json: bool) -> None:
    """Write the files, or remove them; the desktop is told. Raises OutputError."""
    if sys.platform != "linux":
        raise OutputError("this desktop has no such entries", "make a shortcut to trackwright")
    data = data_folder()
    places = [data / place for place in FILES]
    for place, name in zip(places, FILES.values(), strict=True):
        if remove:
            place.unlink(missing_ok=True)
        else:
            _write(place, (_OWN / name).read_bytes())
    _tell_desktop(data)
    if as_json:
        print_json({"removed" if remove else "written": [str(place) for place in places]})
        return
    for place in places:
        print_line(place)


def data_folder() -> Path:
    """Where the user's desktop looks."""
    named = os.environ.get("XDG_DATA_HOME", "")
    return Path(named) if Path(named).is_absolute() else Path.home() / ".local" / "share"


def command() -> str:
    """The program as the desktop can call it, whatever its PATH is."""
    beside = Path(sys.executable).with_name("trackwright")
    found = str(beside) if beside.is_file() else shutil.which("trackwright")
    return found or f"{sys.executable} -m app"


def _write(place: Path, content: bytes) -> None:
    if place.suffix == ".desktop":
        called = _quoted(command()).encode()
        content = content.replace(b"Exec=trackwright ", b"Exec=" + called + b" ")
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(
            "cannot make {folder}: {reason}; have its owner let you",
            folder=place.parent,
            reason=error.strerror,
        ) from error
    replace_with(place, content)


def _quoted(words: str) -> str:
    """A command as the value of Exec, of which some signs are special."""
    if words.isprintable() and not set(words) & set(" \"'\\><~|&;$*?#()`%\t"):
        return words
    inner = words.replace("\\", "\\\\\\\\").replace('"', '\\\\"')
    inner = inner.replace("`", "\\\\`").replace("$", "\\\\$").replace("%", "%%")
    return f'"{inner}"'


def _tell_desktop(data: Path) -> None:
    """Have the desktop read its folders again; without these programs it does at the next login."""
    for program, folder in _REFRESH:
        found = shutil.which(program)
        if found is None or not (data / folder).is_dir():
            continue
        try:
            subprocess.run(
                [found, str(data / folder)],
                check=True,
                timeout=_PATIENCE_S,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
        except (OSError, subprocess.SubprocessError) as error:
            say(msg("note: {program} failed ({error}); log in again", program=program, error=error))
