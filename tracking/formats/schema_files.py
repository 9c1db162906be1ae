"""A schema of attributes in a file of its own.

`attributes.toml` is this program's, e.g. of a project:

    format = 1

    [[attribute]]
    name = "role"
    type = "choice"             # or "yes-no", "number", "text"
    choices = ["guest", "staff"]
    default = "guest"           # shown where nothing is said, not stored
    required = true
    # of a number: least, most, step

A JSON file is what CVAT's label constructor shows under Raw: a list of labels with attributes.
"""

from __future__ import annotations

import json
import os
import re
import stat
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tracking.atomic_output import replacing
from tracking.errors import EditError, FormatError, explain_unreadable
from tracking.formats.cvat_schema import CvatSchema, label_in_cvat
from tracking.formats.label_text import PERSON
from tracking.owned_files import SAFE_FLAGS
from tracking.tracks import Schema
from tracking.tracks.schema_checks import schema_as_values, schema_from_values
from tracking.translation import Message, message_of

SCHEMA_NAME = "attributes.toml"
"""Of a project, in its folder."""
_MOST_BYTES = 1 << 20
_FORMAT = 1
_JSON = re.compile(r"\s*(\[\s*)?\{")
_MOST_LABELS, _MOST_OF_A_LABEL = 1000, 1000
_FOLDERS_UP = 4
"""Above a session's own folder that are looked in: as deep as a project's list reaches."""


@dataclass(frozen=True, slots=True)
class SchemaFile:
    """A schema as a file says it; notes: what of it could not be taken, a line each."""

    schema: Schema
    notes: tuple[Message, ...] = ()


def find_schema_file(folder: Path) -> Path | None:
    """The project's schema for what stands in a folder: there or in a folder above.

    A link is none.
    """
    folder = Path(os.path.abspath(folder))  # noqa: PTH100 - links stay
    for place in (folder, *folder.parents)[: 1 + _FOLDERS_UP]:
        path = place / SCHEMA_NAME
        if path.is_file() and not path.is_symlink():
            return path
    return None


def schema_of_project(*folders: Path) -> SchemaFile:
    """The schema with which a new session begins: of the first folder that has one.

    None is empty; one that cannot be read is empty, too, and its notes say why.
    """
    for folder in folders:
        path = find_schema_file(folder)
        if path is not None:
            try:
                return read_schema(path)
            except FormatError as error:
                return SchemaFile((), (error.message,))
    return SchemaFile(())


def read_schema(path: Path) -> SchemaFile:
    """The schema of a file: TOML, or CVAT's JSON.

    Raises FormatError where it is no such file, or too large.
    """
    text = _text_of(path)
    if path.suffix.lower() == ".json" or _JSON.match(text):
        return _of_cvat(path, text)
    try:
        return SchemaFile(_of_toml(tomllib.loads(text)))
    except (EditError, ValueError, RecursionError) as error:
        raise FormatError("{path}: {why}", path=path, why=message_of(error)) from error


def write_schema(path: Path, schema: Schema) -> None:
    """Write a schema: as CVAT's JSON where the name ends in .json, else as TOML.

    Raises OutputError where it cannot be written.
    """
    text = cvat_json(schema) if path.suffix.lower() == ".json" else schema_toml(schema)
    with replacing(path) as stream:
        stream.write(text)


def schema_toml(schema: Schema) -> str:
    """A schema as the text of `attributes.toml`."""
    lines = [f"format = {_FORMAT}"]
    for values in schema_as_values(schema):
        lines += ["", "[[attribute]]"]
        lines += [f"{key} = {_toml(value)}" for key, value in values.items()]
    return "\n".join(lines) + "\n"


def cvat_json(schema: Schema) -> str:
    """A schema as CVAT's label constructor takes it: one label, person.

    With the attributes `track_id` and `name`, which tracks of this program bring along.
    """
    label = {"name": PERSON, "type": "rectangle", "attributes": label_in_cvat(schema)}
    return json.dumps([label], indent=2, ensure_ascii=False) + "\n"


def _text_of(path: Path) -> str:
    with (
        explain_unreadable(path),
        os.fdopen(os.open(path, os.O_RDONLY | SAFE_FLAGS), "rb") as stream,
    ):
        if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
            raise FormatError("{path} is no plain file; name one", path=path)
        held = stream.read(_MOST_BYTES + 1)
    if len(held) > _MOST_BYTES:
        raise FormatError(
            "{path} is larger than {size} kB; is it a schema of attributes?",
            path=path,
            size=_MOST_BYTES >> 10,
        )
    try:
        return held.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise FormatError("{path}: not text in UTF-8; save it again as UTF-8", path=path) from error


def _of_toml(told: dict[str, Any]) -> Schema:
    if told.get("format") != _FORMAT:
        raise EditError("it has no line format = {format}", format=_FORMAT)
    unknown = sorted(told.keys() - {"format", "attribute"})
    if unknown:
        raise EditError("{unknown} means nothing here", unknown=unknown[0][:100])
    return schema_from_values(told.get("attribute", []))


def _of_cvat(path: Path, text: str) -> SchemaFile:
    try:
        labels = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise FormatError(
            "{path}: not readable as JSON ({error}); copy it anew from CVAT", path=path, error=error
        ) from error
    labels = [labels] if isinstance(labels, dict) else labels
    good = all(isinstance(label, dict) and isinstance(label.get("name"), str) for label in labels)
    if not labels or not good or len(labels) > _MOST_LABELS:
        raise FormatError(
            "{path} is no list of labels as CVAT's label constructor shows under Raw", path=path
        )
    found = CvatSchema()
    for label in labels:
        attributes = label.get("attributes", [])
        if not isinstance(attributes, list) or len(attributes) > _MOST_OF_A_LABEL:
            raise FormatError(
                "{path}: the attributes of label {label} are no list",
                path=path,
                label=label["name"][:100],
            )
        for attribute in attributes:
            if isinstance(attribute, dict):
                found.add(attribute)
    return SchemaFile(tuple(found.by_name.values()), found.notes)


def _toml(value: Any) -> str:
    """A text, a truth, a number or a list of texts as TOML; its strings are nearly JSON's."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
