"""A network on disk: an ONNX file, and a TOML beside it that says how to use it.

Neither is trusted: no links are followed, the ONNX lies in the TOML's folder, sizes are capped.
What is hashed is what is run: both are read once.
"""

from __future__ import annotations

import hashlib
import os
import re
import stat
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tracking.detections.coco_boxes import PEOPLE
from tracking.errors import FormatError, explain_unreadable
from tracking.networks.network_spec import (
    CENTRE,
    CORNER,
    EMBEDDING,
    LETTERBOX,
    ONNXRUNTIME,
    OPENCV,
    STRETCH,
    NetworkSpec,
)
from tracking.networks.toml_table import TomlTable
from tracking.owned_files import SAFE_FLAGS
from tracking.tracks import DetectionsInput

_MOST_TEXT_BYTES = 64 << 10
MOST_MODEL_BYTES = 1 << 30
"""The largest public detectors take 400 MB."""
_MOST_CLASSES = 2000
_SIDE_PX = (16.0, 4096.0)
_KNOWN_CLASSES: Mapping[str, tuple[int, tuple[int, ...]]] = {
    "coco": (80, (0,)),
    "coco91": (91, (1,)),
}
"""How many classes there are, which are people: of COCO without gaps, and by category ids."""
_DECODERS = ("yolox", "yolo", "detr", "boxes")
_IMAGENET = {"mean": (0.485, 0.456, 0.406), "std": (0.229, 0.224, 0.225)}
_USUAL: Mapping[str, Mapping[str, Any]] = {
    "yolox": {"align": CORNER, "channels": "bgr", "divide_by": 1.0},
    "yolo": {},
    "detr": {"fit": STRETCH, **_IMAGENET},
    "boxes": {},
}
"""What a decoder's networks want of their input, where it is not how `NetworkSpec` has it."""
_WORDS: Mapping[str, tuple[str, ...]] = {
    "engine": (OPENCV, ONNXRUNTIME),
    "fit": (LETTERBOX, STRETCH),
    "align": (CENTRE, CORNER),
    "channels": ("rgb", "bgr"),
    "head": ("v5", "v8", "v10"),
    "activation": ("softmax", "sigmoid", "none"),
    "sides": ("corners", "centre", "sides"),
    "unit": ("pixels", "shares"),
}
_NUMBERS: Mapping[str, tuple[float, float]] = {
    "pad": (0.0, 255.0),
    "divide_by": (1e-6, 1e6),
    "min_score": (0.0, 1.0),
}
_OF_DECODER = {"head": "yolo", "decoded": "yolox", "activation": "detr"}
_OF_DECODER |= {"sides": "boxes", "unit": "boxes"}
_OUTPUTS = ("boxes", "scores", "labels")
_TAKEN = frozenset((*_WORDS, *_NUMBERS, "mean", "std", "decoded", "size_input"))
_APPEARANCE = "appearance"
"""The kind of a TOML that describes an appearance network, and the table of one beside others."""
_OWN = frozenset(("decoder", "classes", _APPEARANCE))
_INPUT = frozenset(("engine", "fit", "align", "channels", "pad", "divide_by", "mean", "std"))
_FILES = frozenset(("name", "file", "sha256", "licence", "size", "outputs"))
"""Keys of every network."""
_SHA256 = re.compile(r"[0-9a-fA-F]{64}")


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """A network that was read, not yet run.

    Attributes:
        path: of the TOML. name: of the network, for people. licence: as the TOML says.
        spec: how to use it. onnx: all bytes of the ONNX file.
        fingerprint: SHA-256 of the TOML's bytes and then the ONNX's, in hex.
        appearance: the appearance network that the TOML describes beside it; None: none.
    """

    path: Path
    name: str
    licence: str
    spec: NetworkSpec
    onnx: bytes
    fingerprint: str
    appearance: Model | None = None

    @property
    def is_appearance(self) -> bool:
        """Whether it describes people, and finds none."""
        return self.spec.decoder == EMBEDDING

    def as_input(self, file_format: str, count: int) -> DetectionsInput:
        """What a run keeps of it. count: of the boxes or crops so far."""
        return DetectionsInput(
            camera="",
            file=self.path.name,
            format=file_format,
            fingerprint=self.fingerprint,
            count=count,
            network=self.name,
            decoder=self.spec.decoder,
            licence=self.licence,
        )


def read_model(place: Path) -> Model:
    """The network of a TOML, or of the only one in a folder.

    Raises FormatError where one of the files is missing, a link, too large, or says what no network
    has.
    """
    path = _toml_in(place)
    text = _bytes_of(path, _MOST_TEXT_BYTES, "the TOML of a network")
    told = TomlTable(path, _parsed(path, text))
    if told.table.get("kind") == _APPEARANCE:
        return _read_appearance(told, text, f"{path.stem}.onnx")
    if "kind" in told.table:
        raise told.wrong("kind", _APPEARANCE + ", or left out")
    table = told.table.get(_APPEARANCE, {})
    if not isinstance(table, dict):
        raise told.wrong(_APPEARANCE, "a table")
    within = TomlTable(path, table, f"{_APPEARANCE}.")
    beside = _read_appearance(within, text, None) if table else None
    found = _read(told, text, _spec_of(told), f"{path.stem}.onnx")
    return replace(found, appearance=beside)


def is_appearance(place: Path) -> bool:
    """Whether a TOML is of an appearance network; False for what cannot be read."""
    try:
        path = _toml_in(place)
        return _parsed(path, _bytes_of(path, _MOST_TEXT_BYTES, "")).get("kind") == _APPEARANCE
    except FormatError:
        return False


def _read_appearance(told: TomlTable, text: bytes, file: str | None) -> Model:
    """An appearance network; `file`: its ONNX where the table names none, None: it has to."""
    told.refuse_unknown(_INPUT | _FILES | {"kind"})
    given: dict[str, Any] = {"fit": STRETCH, **_IMAGENET, **_input_of(told)}
    given |= told.outputs((EMBEDDING,))
    size = told.size(*_SIDE_PX)
    spec = NetworkSpec(EMBEDDING, size_px=size, class_count=0, people=(), **given)
    return _read(told, text, spec, file)


def _read(told: TomlTable, text: bytes, spec: NetworkSpec, file: str | None) -> Model:
    name, licence = told.text("name", told.path.stem), told.text("licence")
    onnx = _onnx_of(told, file)
    digest = hashlib.sha256(text)
    digest.update(onnx)
    return Model(told.path, name, licence, spec, onnx, digest.hexdigest())


def _toml_in(place: Path) -> Path:
    if place.is_symlink():
        raise FormatError(
            "{path} is a link, which is not followed; name the file it leads to", path=place
        )
    if not place.is_dir():
        return place
    with explain_unreadable(place):
        found = sorted(path for path in place.iterdir() if path.suffix.lower() == ".toml")
    if len(found) != 1:
        raise FormatError(
            "{path} has {count} TOML files; name the one of the network",
            path=place,
            count=len(found),
        )
    return found[0]


def _bytes_of(path: Path, most: int, what: str) -> bytes:
    """All bytes of a plain file that is no larger than what it is to be."""
    with (
        explain_unreadable(path),
        os.fdopen(os.open(path, os.O_RDONLY | SAFE_FLAGS), "rb") as stream,
    ):
        state = os.fstat(stream.fileno())
        if not stat.S_ISREG(state.st_mode):
            raise FormatError("{path} is no plain file; name one", path=path)
        held = b"" if state.st_size > most else stream.read(most + 1)
    if len(held) > most or state.st_size > most:
        raise FormatError(
            "{path} is larger than {size} kB; is it {what}?", path=path, size=most >> 10, what=what
        )
    if not held:
        raise FormatError("{path} is empty", path=path)
    return held


def _parsed(path: Path, text: bytes) -> dict[str, Any]:
    try:
        return tomllib.loads(text.decode("utf-8"))
    except (ValueError, RecursionError) as error:
        raise FormatError(
            "{path}: not readable as TOML ({error}); correct it there", path=path, error=error
        ) from error


def _onnx_of(told: TomlTable, usual: str | None) -> bytes:
    """The bytes of the ONNX file, which is the one that is meant where the TOML says a SHA-256."""
    file = told.text("file", usual)
    if file in (".", "..") or re.search(r"[/\\:\0]", file):
        raise told.wrong("file", "the name of a file in the same folder")
    path = told.path.parent / file
    held = _bytes_of(path, MOST_MODEL_BYTES, "an ONNX file")
    expected = told.text("sha256", "")
    if expected and not _SHA256.fullmatch(expected):
        raise told.wrong("sha256", "64 hexadecimal digits")
    if expected and hashlib.sha256(held).hexdigest() != expected.lower():
        raise FormatError(
            "{path} is not the file that {toml} means: its SHA-256 is another one",
            path=path,
            toml=told.path.name,
        )
    return held


def _input_of(told: TomlTable) -> dict[str, Any]:
    """What a table says of the engine, the input and the score, as fields of `NetworkSpec`."""
    table = told.table
    given: dict[str, Any] = {
        key: told.word(key, words) for key, words in _WORDS.items() if key in table
    }
    given |= {key: told.number(key, *span) for key, span in _NUMBERS.items() if key in table}
    if "mean" in table:
        given["mean"] = told.numbers("mean", 3, -1e6, 1e6)
    if "std" in table:
        given["std"] = told.numbers("std", 3, 1e-6, 1e6)
    return given


def _spec_of(told: TomlTable) -> NetworkSpec:
    decoder = told.word("decoder", _DECODERS)
    told.refuse_unknown(_TAKEN | _OWN | _FILES)
    for key, owner in _OF_DECODER.items():
        if key in told.table and owner != decoder:
            raise FormatError(
                "{path}: {key} is of decoder {owner}, not of {decoder}; leave it out",
                path=told.path,
                key=key,
                owner=owner,
                decoder=decoder,
            )
    given: dict[str, Any] = {**_USUAL[decoder], **_input_of(told)}
    if "decoded" in told.table:
        given["decoded"] = told.yes("decoded")
    if "size_input" in told.table:
        given["size_input"] = told.text("size_input")
    if given.get("size_input") and given.get("engine") != ONNXRUNTIME:
        raise FormatError(
            '{path}: OpenCV\'s engine has no size_input; write engine = "onnxruntime"',
            path=told.path,
        )
    given |= told.outputs(_OUTPUTS)
    size = told.size(*_SIDE_PX)
    count, people = _classes(told)
    return NetworkSpec(decoder=decoder, size_px=size, class_count=count, people=people, **given)  # type: ignore[arg-type]


def _classes(told: TomlTable) -> tuple[int, tuple[int, ...]]:
    """How many classes there are, and the numbers of those that are people."""
    value = told.value("classes")
    if isinstance(value, str) and value in _KNOWN_CLASSES:
        return _KNOWN_CLASSES[value]
    if (
        not isinstance(value, list)
        or not 0 < len(value) <= _MOST_CLASSES
        or not all(isinstance(name, str) for name in value)
    ):
        raise told.wrong("classes", "coco, coco91 or a list of names")
    people = [at for at, name in enumerate(value) if name.strip().lower() in PEOPLE]
    if not people:
        raise FormatError(
            "{path}: none of its classes is person; rename the one of people", path=told.path
        )
    return len(value), tuple(people)
