"""What is to be done with every recording of a batch, and the limits it is done within."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any, Self

from tracking.errors import FormatError
from tracking.plugins import PluginKind
from tracking.plugins.code_digest import plugin_digests
from tracking.stamps import software

_CHUNK_BYTES = 1 << 20
_DETECTOR, _NETWORKS = "detector", ("detections.model", "detections.appearance")
"""Settings whose value may be a file or a folder: what it holds counts, not where it is."""


@dataclass(frozen=True, slots=True)
class BatchOrder:
    """The same for all recordings; plain values, so that any process understands it.

    Attributes:
        tracker: name in the catalogue; "": the best one for each recording.
        settings: typed texts by the dotted names of settings. seed: of all random numbers.
        detections, detections_right: patterns of files of boxes, see `detections_of`; "": none.
        exports: names of formats that each result is written in.
        report: whether a page is written on each recording with ground truth.
        allow_outside: a manifest may name files outside its folder.
        force: sessions that somebody corrected are replaced where they would be made anew.
    """

    tracker: str = ""
    settings: tuple[tuple[str, str], ...] = ()
    seed: int = 0
    detections: str = ""
    detections_right: str = ""
    exports: tuple[str, ...] = ()
    report: bool = True
    allow_outside: bool = False
    force: bool = False

    def as_data(self) -> dict[str, Any]:
        """As JSON holds it."""
        return asdict(self)

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """What `as_data` gave."""
        values = {each.name: data[each.name] for each in fields(cls)}
        values["settings"] = tuple((str(name), str(text)) for name, text in data["settings"])
        values["exports"] = tuple(data["exports"])
        return cls(**values)

    def tracking_digest(self) -> str:
        """A digest of all that decides what a tracker finds in given files, as hex.

        Files that settings name count with what they hold, plug-ins with their code. Raises OSError
        where one is unreadable.
        """
        settings = sorted((name, _value_digest(name, text)) for name, text in self.settings)
        asked = [(PluginKind.TRACKER, self.tracker)]
        asked += [
            (PluginKind.DETECTOR, text) for name, text in self.settings if name == _NETWORKS[0]
        ]
        return digest_of([self.tracker, settings, self.seed, software(), *plugin_digests(asked)])


@dataclass(frozen=True, slots=True)
class Limits:
    """What one recording may cost; None: any.

    Attributes:
        time_s: by the clock, all of it. stall_s: without any sign of progress.
        memory_bytes: of the process that works on it, beyond what it has when it begins.
    """

    time_s: float | None = None
    stall_s: float | None = 600.0
    memory_bytes: int | None = None


def digest_of(value: object) -> str:
    """A digest of plain values, as hex."""
    return hashlib.sha256(json.dumps(value, sort_keys=True).encode()).hexdigest()


def content_digest(files: Iterable[Path]) -> str:
    """A digest of all bytes of files, in their order. Raises OSError where one is unreadable."""
    digest = hashlib.sha256()
    for file in files:
        digest.update(b"%d " % file.stat().st_size)
        with file.open("rb") as stream:
            while chunk := stream.read(_CHUNK_BYTES):
                digest.update(chunk)
    return digest.hexdigest()


def files_in(place: Path) -> Iterator[Path]:
    """The regular files at a place, which may be a folder, by name."""
    if place.is_dir():
        yield from sorted(each for each in place.rglob("*") if each.is_file())
    elif place.is_file():
        yield place


def _value_digest(name: str, text: str) -> str:
    place = Path(text)
    if text and name in (_DETECTOR, *_NETWORKS) and place.exists():
        return content_digest(files_in(place)) if name == _DETECTOR else _network_digest(place)
    return text


def _network_digest(place: Path) -> str:
    """A digest of the TOML and the ONNX files that a network is read from, and of no others."""
    from tracking.networks.model_file import read_model  # takes long to import

    try:
        model = read_model(place)
    except FormatError:  # whoever tracks with it will tell; any file may be what mends it
        return content_digest(files_in(place.parent if place.suffix == ".toml" else place))
    beside = model.appearance
    return digest_of([model.fingerprint, "" if beside is None else beside.fingerprint])
