"""What the checks of all kinds share: how a broken rule is told, hostile bytes, the door."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import Any

import numpy as np

from tracking.errors import PluginError, TrackwrightError
from tracking.plugins import Catalogue, PluginKind, offered_for_a_while


class BrokenRule(AssertionError):  # noqa: N818 - a failed test
    """A plug-in does not do what every one of its kind must."""


def require(kept: object, what: str, **values: object) -> None:
    """Raise BrokenRule unless the rule is kept; what: the rule, with {named} places."""
    if not kept:
        raise BrokenRule(what.format(**values))


@contextmanager
def obeying() -> Iterator[None]:
    """What a plug-in is blamed for as it is used is a broken rule."""
    try:
        yield
    except PluginError as error:
        raise BrokenRule(str(error.reason)) from error


def check_installed(kind: PluginKind | str, name: str) -> None:
    """The package is installed, and its entry point leads to something that can be used."""
    catalogue = _catalogue(PluginKind(kind))
    require(
        name in catalogue.names,
        'no {kind} {name} is installed: name it under [project.entry-points."{group}"] in '
        "pyproject.toml, and install the package (pip install -e .)",
        kind=kind,
        name=name,
        group=PluginKind(kind).group,
    )
    with obeying():
        catalogue[name]


def _catalogue(kind: PluginKind) -> Catalogue[Any]:
    from tracking.detections.catalogue import DETECTORS
    from tracking.formats import FORMATS
    from tracking.recording.kinds.catalogue import KINDS
    from tracking.trackers import TRACKERS

    catalogues: dict[PluginKind, Catalogue[Any]] = {
        PluginKind.TRACKER: TRACKERS,
        PluginKind.FORMAT: FORMATS,
        PluginKind.RECORDING: KINDS,
        PluginKind.DETECTOR: DETECTORS,
    }
    return catalogues[kind]


def at_the_door(catalogue: Catalogue[Any], thing: Any) -> AbstractContextManager[object]:
    """Offer a thing while it is checked, unless it is installed or built in already.

    Raises BrokenRule: its name is that of one that is built in, and it is another.
    """
    offer = catalogue.offer(thing.name)
    if offer is not None:
        require(
            not offer.built_in or catalogue[thing.name] is thing,
            "the name {name} is that of one that is built in; choose another",
            name=thing.name,
        )
        return nullcontext()
    return offered_for_a_while(catalogue.kind, thing.name, thing, type(thing).__module__)


def hostile_heads() -> Iterator[bytes]:
    """Beginnings of files that are of no format."""
    noise = np.random.default_rng(5)
    yield b""
    yield b"\x00" * 4096
    yield b"\xff\xfe\xff\xfe" * 64
    yield b"," * 5000
    yield b"{" * 5000
    yield b"<" * 5000
    yield "x, y\n\u20ac".encode() * 50
    yield b"nan,inf,-inf,1e999\n" * 20
    yield from (noise.bytes(size) for size in (1, 16, 4096))


def never_raises(call: Callable[[], object], what: str) -> object:
    """What a call gives that must not raise, whatever it is given."""
    try:
        return call()
    except BaseException as error:
        raise BrokenRule(
            f"{what} raised {type(error).__name__}: {error}; it must never raise"
        ) from error


def raises_ours_alone(call: Callable[[], object], what: str) -> object:
    """What a call gives, None where it raised an error of ours; any other one breaks the rule."""
    try:
        return call()
    except PluginError as error:
        raise BrokenRule(f"{what}: {error.reason}") from error
    except TrackwrightError:
        return None
    except Exception as error:
        raise BrokenRule(
            f"{what} raised {type(error).__name__}: {error}; raise a FormatError that says what is "
            "wrong and where"
        ) from error


@contextmanager
def leaving_nothing_open(what: str) -> Iterator[None]:
    """No file and no thread may stay behind."""
    files, threads = _open_files(), threading.active_count()
    yield
    for thread in threading.enumerate():
        if thread is not threading.current_thread() and not thread.daemon:
            thread.join(1.0)
    require(_open_files() <= files, "{who} leaves files open; close them", who=what)
    left = threading.active_count() - threads
    require(left <= 0, "{who} leaves {n} threads at work; end them", who=what, n=left)


def _open_files() -> int:
    folder = Path("/proc/self/fd")
    return len(list(folder.iterdir())) if folder.is_dir() else 0
