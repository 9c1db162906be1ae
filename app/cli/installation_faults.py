"""Faults of an installation that break it later: other copies of a library, damage, no room."""

from __future__ import annotations

import hashlib
import importlib.metadata
import importlib.util
import os
import shutil
import sys
import tempfile
from base64 import urlsafe_b64decode
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Final

import resources
from app.cli.plugins import find_plugins
from tracking.translation import Message, joined, msg

IS_BUNDLE: Final = bool(getattr(sys, "frozen", False))
"""Whether the program runs from a folder with its own Python, see `app.bundle`."""

_NAME = "trackwright"
_OWN = ("app", "tracking", "resources")
_OPENCV = ("opencv-python", "opencv-contrib-python", "opencv-contrib-python-headless")
"""Each holds a `cv2` of its own, and whichever was installed last is the one that is imported."""
_QT_PLACES = ("QT_PLUGIN_PATH", "QT_QPA_PLATFORM_PLUGIN_PATH")
_LIBRARIES = "LD_LIBRARY_PATH"
_LEAST_BYTES = 1 << 30
"""Recordings are rendered and particles put aside there."""

Fault = tuple[str, Message, bool]
"""A name, what is wrong with what to do about it, and whether something needed does not work."""


def find_faults(folders: Mapping[str, Path]) -> Iterator[Fault]:
    """Everything that is wrong; folders: that are written to, by what they are."""
    yield from _second_opencv()
    yield from _second_qt()
    yield from _damaged_resources()
    yield from _full_disks({**folders, "temporary folder": Path(tempfile.gettempdir())})
    yield from _broken_plugins()


def _second_opencv() -> Iterator[Fault]:
    there = [name for name in _OPENCV if _is_installed(name)]
    if there:
        yield (
            "opencv",
            msg(
                "{others} stands in the place of opencv-python-headless; pip uninstall {others}, "
                "then pip install --force-reinstall opencv-python-headless",
                others=joined(" ", there),
            ),
            True,
        )


def _is_installed(name: str) -> bool:
    try:
        importlib.metadata.distribution(name)
    except importlib.metadata.PackageNotFoundError:
        return False
    return True


def _second_qt() -> Iterator[Fault]:
    """Plugins of another Qt, which abort ours."""
    found = importlib.util.find_spec("PySide6")
    own = Path((found and found.origin) or os.devnull).parent
    for name in _QT_PLACES:
        place = os.environ.get(name)
        if place and not Path(place).is_relative_to(own):  # a bundle leads to its own
            yield (
                "second qt",
                msg("{name}={place} leads to another Qt; unset {name}", name=name, place=place),
                True,
            )
    for folder in filter(None, os.environ.get(_LIBRARIES, "").split(os.pathsep)):
        if Path(folder) != own.parent and any(Path(folder).glob("libQt6Core.so*")):
            said = msg(
                "{name} holds another Qt in {folder}; take it out", name=_LIBRARIES, folder=folder
            )
            yield "second qt", said, True


def _damaged_resources() -> Iterator[Fault]:
    """Files of this program that are not as they were installed; a checkout has no such list."""
    cure = (
        msg("install or unpack trackwright again")
        if IS_BUNDLE
        else msg("pip install --force-reinstall --no-deps trackwright")
    )
    if not (Path(resources.__file__).parent / "part_failures_paper.h5").is_file():
        yield "resources", msg("files are missing; {cure}", cure=cure), True
        return
    try:
        files = importlib.metadata.files(_NAME) or []
    except importlib.metadata.PackageNotFoundError:
        return
    wrong = [str(one) for one in files if _is_wrong(one)]
    if wrong:
        yield (
            "resources",
            msg(
                "{n} files were changed or lost, e.g. {file}; {cure}",
                n=len(wrong),
                file=wrong[0],
                cure=cure,
            ),
            True,
        )


def _is_wrong(file: importlib.metadata.PackagePath) -> bool:
    if file.hash is None or file.hash.mode != "sha256" or file.suffix == ".pyc":
        return False
    if IS_BUNDLE and file.parts[0] not in _OWN:  # neither its command nor its menu entry
        return False
    try:
        held = Path(str(file.locate())).read_bytes()
    except OSError:
        return True
    wanted = urlsafe_b64decode(file.hash.value + "=" * (-len(file.hash.value) % 4))
    return hashlib.sha256(held).digest() != wanted


def _full_disks(folders: Mapping[str, Path]) -> Iterator[Fault]:
    for name, folder in folders.items():
        there = next((one for one in (folder, *folder.parents) if one.exists()), Path(sys.prefix))
        free = shutil.disk_usage(there).free
        if free < _LEAST_BYTES:
            said = msg(
                "{free:.0f} MB are free at {folder}; make room", free=free / 1e6, folder=there
            )
            yield f"room for {name}", said, True


def _broken_plugins() -> Iterator[Fault]:
    for one in find_plugins():
        if one.error is not None:
            yield f"plug-in {one.offer.name}", one.error.message, False
