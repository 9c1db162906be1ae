"""A network on disk: an ONNX file, and a TOML beside it that says how to use it.

Neither is trusted: no links are followed, the ONNX lies in the TOML's folder, sizes are capped.
What is hashed is what is run: both are read once.
"""

from __future__ import annotations

import hashlib
import math
import os
import re
import stat
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tracking.detections.coco_boxes import PEOPLE
from tracking.errors import FormatError, explain_unreadable
from tracking.networks.network_spec import (
    CENTRE,
    CORNER,
    LETTERBOX,
    ONNXRUNTIME,
    OPENCV,
    STRETCH,
    NetworkSpec,
)
from tracking.owned_files import SAFE_FLAGS

_MOST_TEXT_BYTES = 64 << 10
MOST_MODEL_BYTES = 1 << 30
"""The largest public detectors take 400 MB."""
_LONGEST_NAME = 100
_MOST_CLASSES = 2000
_SIDE_PX = (16, 4096)
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
_OWN = frozenset(("name", "file", "sha256", "licence", "decoder", "classes", "size", "outputs"))
_SHA256 = re.compile(r"[0-9a-fA-F]{64}")


@dataclass(frozen=True, slots=True, eq=False)
class Model:
    """A network that was read, not yet run.

    Attributes:
        path: of the TOML. name: of the network, for people. licence: as the TOML says.
        spec: how to use it. onnx: all bytes of the ONNX file.
        fingerprint: SHA-256 of the TOML's bytes and then the ONNX's, in hex.
    """

    path: Path
    name: str
    licence: str
    spec: NetworkSpec
    onnx: bytes
    fingerprint: str


def read_model(place: Path) -> Model:
    """The network of a TOML, or of the only one in a folder.

    Raises FormatError where one of the files is missing, a link, too large, or says what no network
    has.
    """
    path = _toml_in(place)
    text = _bytes_of(path, _MOST_TEXT_BYTES, "the TOML of a network")
    told = _Told(path, _parsed(path, text))
    name = told.text("name", path.stem)
    spec, licence = _spec_of(told), told.text("licence")
    onnx = _onnx_of(told)
    digest = hashlib.sha256(text)
    digest.update(onnx)
    return Model(path, name, licence, spec, onnx, digest.hexdigest())


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


def _onnx_of(told: _Told) -> bytes:
    """The bytes of the ONNX file, which is the one that is meant where the TOML says a SHA-256."""
    file = told.text("file", f"{told.path.stem}.onnx")
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


def _spec_of(told: _Told) -> NetworkSpec:
    decoder = told.word("decoder", _DECODERS)
    told.refuse_unknown(_TAKEN | _OWN)
    for key, owner in _OF_DECODER.items():
        if key in told.table and owner != decoder:
            raise FormatError(
                "{path}: {key} is of decoder {owner}, not of {decoder}; leave it out",
                path=told.path,
                key=key,
                owner=owner,
                decoder=decoder,
            )
    given: dict[str, Any] = dict(_USUAL[decoder])
    given |= {key: told.word(key, words) for key, words in _WORDS.items() if key in told.table}
    given |= {key: told.number(key, *span) for key, span in _NUMBERS.items() if key in told.table}
    if "mean" in told.table:
        given["mean"] = told.numbers("mean", 3, -1e6, 1e6)
    if "std" in told.table:
        given["std"] = told.numbers("std", 3, 1e-6, 1e6)
    if "decoded" in told.table:
        given["decoded"] = told.yes("decoded")
    if "size_input" in told.table:
        given["size_input"] = told.text("size_input")
    if given.get("size_input") and given.get("engine") != ONNXRUNTIME:
        raise FormatError(
            '{path}: OpenCV\'s engine has no size_input; write engine = "onnxruntime"',
            path=told.path,
        )
    given |= told.outputs()
    width, height = told.numbers("size", 2, *map(float, _SIDE_PX))
    if not (width.is_integer() and height.is_integer()):
        raise told.wrong("size", "[width, height] in whole px")
    count, people = told.classes()
    size = int(width), int(height)
    return NetworkSpec(decoder=decoder, size_px=size, class_count=count, people=people, **given)  # type: ignore[arg-type]


class _Told:
    """The table of a TOML, read strictly."""

    def __init__(self, path: Path, table: Mapping[str, Any]) -> None:
        self.path, self.table = path, table

    def wrong(self, key: str, expected: str) -> FormatError:
        """An error that says what a key must be."""
        return FormatError(
            "{path}: {key} must be {expected}", path=self.path, key=key, expected=expected
        )

    def refuse_unknown(self, known: frozenset[str]) -> None:
        """Refuse keys that nothing reads: a misspelt one would be ignored."""
        for key in self.table.keys() - known:
            raise FormatError(
                "{path}: {key} is no key of a network; docs/networks.md lists them",
                path=self.path,
                key=key[:_LONGEST_NAME],
            )

    def _value(self, key: str) -> Any:
        if key not in self.table:
            raise FormatError(
                "{path}: {key} is missing; docs/networks.md says what it is",
                path=self.path,
                key=key,
            )
        return self.table[key]

    def text(self, key: str, otherwise: str | None = None) -> str:
        """A short text of one line."""
        value = self._value(key) if otherwise is None else self.table.get(key, otherwise)
        if not isinstance(value, str) or len(value) > _LONGEST_NAME or not value.isprintable():
            raise self.wrong(key, f"a text of at most {_LONGEST_NAME} characters")
        if not value.strip() and otherwise is None:
            raise self.wrong(key, "a text")
        return value.strip()

    def word(self, key: str, words: tuple[str, ...]) -> str:
        """One of some words."""
        value = self._value(key)
        if value not in words:
            raise self.wrong(key, " or ".join(words))
        return str(value)

    def yes(self, key: str) -> bool:
        """Whether it is true."""
        value = self._value(key)
        if not isinstance(value, bool):
            raise self.wrong(key, "true or false")
        return value

    def number(self, key: str, low: float, high: float) -> float:
        """A number of a range."""
        return self._number(key, self._value(key), low, high, f"a number from {low:g} to {high:g}")

    def numbers(self, key: str, count: int, low: float, high: float) -> tuple[float, ...]:
        """So many numbers of a range."""
        expected = f"{count} numbers from {low:g} to {high:g}"
        value = self._value(key)
        if not isinstance(value, list) or len(value) != count:
            raise self.wrong(key, expected)
        return tuple(self._number(key, each, low, high, expected) for each in value)

    def _number(self, key: str, value: Any, low: float, high: float, expected: str) -> float:
        known = isinstance(value, int | float) and not isinstance(value, bool)
        if not known or not math.isfinite(value) or not low <= value <= high:
            raise self.wrong(key, expected)
        return float(value)

    def outputs(self) -> dict[str, str]:
        """The names of outputs, as fields of `NetworkSpec`."""
        table = self.table.get("outputs", {})
        if not isinstance(table, dict) or table.keys() - set(_OUTPUTS):
            raise self.wrong("outputs", "a table of {}".format(", ".join(_OUTPUTS)))
        names = _Told(self.path, table)
        return {f"{key}_output": names.text(key) for key in table}

    def classes(self) -> tuple[int, tuple[int, ...]]:
        """How many classes there are, and the numbers of those that are people."""
        value = self._value("classes")
        if isinstance(value, str) and value in _KNOWN_CLASSES:
            return _KNOWN_CLASSES[value]
        if (
            not isinstance(value, list)
            or not 0 < len(value) <= _MOST_CLASSES
            or not all(isinstance(name, str) for name in value)
        ):
            raise self.wrong("classes", "coco, coco91 or a list of names")
        people = [at for at, name in enumerate(value) if name.strip().lower() in PEOPLE]
        if not people:
            raise FormatError(
                "{path}: none of its classes is person; rename the one of people", path=self.path
            )
        return len(value), tuple(people)
