"""What is wrong with this installation: Python, libraries, Qt, extras, folders it writes to."""

from __future__ import annotations

import importlib
import importlib.metadata
import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import platformdirs

from app.cli.installation_faults import IS_BUNDLE, find_faults
from app.cli.session_faults import find_session_faults, recent_sessions
from app.cli.system_libraries import this_machine
from tracking.translation import FONT_PACKAGES, Message, language_in_use, msg

_PYTHON = (3, 11)
"""As pyproject.toml asks."""
_NEEDED = ("numpy", "cv2", "scipy", "sklearn", "av", "h5py", "PySide6", "yaml")
_EXTRAS = {"onnx": ("onnxruntime",), "bags": ("rosbags", "mcap"), "pandas": ("pandas",)}
_NAME = "trackwright"


@dataclass(frozen=True, slots=True)
class Check:
    """One thing looked at.

    Attributes:
        name: of it. is_well: nothing to do. said: its version, or what is wrong and what to do.
        needed: without it something that every user needs does not work.
    """

    name: str
    is_well: bool
    said: Message | str
    needed: bool = True


def check_installation() -> Iterator[Check]:
    """Everything looked at, in order."""
    version = platform.python_version()
    too_old = msg("{version}; install Python 3.11 or newer", version=version)
    is_new = sys.version_info >= _PYTHON
    yield Check("python", is_new, version if is_new else too_old)
    yield from (_imported(name) for name in _NEEDED)
    missing = this_machine().missing()
    python = "trackwright" if IS_BUNDLE else "python"
    advice = msg(
        "{missing}; run {python} -m app.cli.system_libraries", missing=missing, python=python
    )
    yield Check("qt", not missing, advice if missing else msg("the window can start"))
    yield _display()
    offered = importlib.metadata.metadata(_NAME).get_all("Provides-Extra") or ()
    for extra, names in _EXTRAS.items():
        if extra not in offered or IS_BUNDLE:  # nobody can add to what is bundled
            continue
        yield from (_imported(name, extra) for name in names)
    yield from _letters()
    for name, folder in _folders().items():
        yield _writable(name, folder)
    for name, said, needed in find_faults(_folders()):
        yield Check(name, False, said, needed)
    yield from check_sessions(recent_sessions())


def check_sessions(sessions: Iterable[Path]) -> Iterator[Check]:
    """What is odd with sessions; nothing of those that open as they should."""
    for name, said, needed in find_session_faults(sessions):
        yield Check(name, False, said, needed)


def _imported(name: str, extra: str = "") -> Check:
    try:
        module = importlib.import_module(name)
    except (ImportError, OSError) as error:
        if extra:
            said = msg('not installed; for it: pip install "trackwright[{extra}]"', extra=extra)
        else:
            said = msg("{reason}; install trackwright again", reason=error)
        return Check(name, False, said, needed=not extra)
    return Check(name, True, str(getattr(module, "__version__", "")) or msg("installed"))


def _display() -> Check:
    if sys.platform != "linux":
        return Check("display", True, msg("there"))
    named = next((name for name in ("WAYLAND_DISPLAY", "DISPLAY") if os.environ.get(name)), None)
    if named is not None:
        return Check("display", True, f"{named}={os.environ[named]}")
    said = msg("none; the window needs a screen, commands work without")
    return Check("display", False, said, needed=False)


def _letters() -> Iterator[Check]:
    """Whether a font has the letters of the language in use; nothing where that is not known."""
    language = language_in_use().partition("_")[0]
    asks = shutil.which("fc-list")
    if language not in FONT_PACKAGES or asks is None or sys.platform != "linux":
        return
    found = subprocess.run([asks, f":lang={language}"], capture_output=True, check=False)
    advice = msg(
        "no font has the letters of the language; e.g. apt-get install {package}",
        package=FONT_PACKAGES[language],
    )
    there = bool(found.stdout.strip())
    yield Check("fonts", there, msg("there") if there else advice, needed=False)


def _folders() -> dict[str, Path]:
    kinds: dict[str, Callable[..., Path]] = {
        "settings folder": platformdirs.user_config_path,
        "data folder": platformdirs.user_data_path,
        "log folder": platformdirs.user_log_path,
    }
    return {name: where(_NAME, appauthor=False) for name, where in kinds.items()}


def _writable(name: str, folder: Path) -> Check:
    """Of a folder that is not there yet, the nearest one above it that is counts."""
    there = folder
    while not there.exists() and there != there.parent:
        there = there.parent
    if there.is_dir() and os.access(there, os.W_OK | os.X_OK):
        return Check(name, True, str(folder))
    return Check(name, False, msg("{folder} is not writable; have its owner let you", folder=there))
