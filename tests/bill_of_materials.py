"""What an installation consists of, with licences: `python -m tests.bill_of_materials [FILE]`.

A bill of materials (SBOM) in CycloneDX's JSON, made of what is installed beside this interpreter:
the program, and all it needs, without what only developers need. Without a file: a table.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path
from typing import Any

from packaging.requirements import Requirement

ROOT = Path(__file__).parents[1]
_OWN = "trackwright"
_FORMAT = "1.5"
_CLASSIFIER = "License :: OSI Approved :: "


@dataclass(frozen=True, slots=True)
class Component:
    """A distribution: its name, version, licence as it says it itself, and size in bytes."""

    name: str
    version: str
    licence: str
    size: int


def components(root: str = _OWN) -> list[Component]:
    """The program and everything it needs, by name."""
    waiting, found = [root], dict[str, Component]()
    while waiting:
        name = _normal(waiting.pop())
        if name in found:
            continue
        try:
            held = distribution(name)
        except PackageNotFoundError:
            continue  # of another system or Python, as its marker says
        found[name] = Component(name, held.version, licence_of(held), _size(held))
        waiting += _needed(held)
    return sorted(found.values(), key=lambda one: one.name)


def _needed(held: Distribution) -> Iterator[str]:
    for text in held.requires or ():
        wanted = Requirement(text)
        if wanted.marker is None or wanted.marker.evaluate({"extra": ""}):
            yield wanted.name


def _normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def licence_of(held: Distribution) -> str:
    """The licence that a distribution names; "" where it names none."""
    told = held.metadata.get("License-Expression") or ""
    if not told:
        classifiers = held.metadata.get_all("Classifier") or ()
        names = [one.removeprefix(_CLASSIFIER) for one in classifiers if _CLASSIFIER in one]
        told = " AND ".join(names)
    if not told:
        told = (held.metadata.get("License") or "").strip().partition("\n")[0]
    return told


def _size(held: Distribution) -> int:
    return sum(one.size or 0 for one in held.files or ())


def document(found: list[Component]) -> dict[str, Any]:
    """CycloneDX: the program is what is described, the rest are its components."""
    own = next(one for one in found if one.name == _OWN)
    return {
        "bomFormat": "CycloneDX",
        "specVersion": _FORMAT,
        "version": 1,
        "metadata": {"component": {"type": "application", **_described(own)}},
        "components": [{"type": "library", **_described(one)} for one in found if one.name != _OWN],
    }


def _described(one: Component) -> Mapping[str, Any]:
    said = {"name": one.name, "version": one.version, "purl": f"pkg:pypi/{one.name}@{one.version}"}
    return said | ({"licenses": [{"license": {"name": one.licence}}]} if one.licence else {})


def main() -> None:
    """Write the file, or print a table."""
    found = components()
    if len(sys.argv) > 1:
        text = json.dumps(document(found), indent=2) + "\n"
        Path(sys.argv[1]).write_text(text, encoding="utf-8")
        return
    for one in found:
        print(f"{one.name:28} {one.version:14} {one.size / 1e6:7.1f} MB  {one.licence}")


if __name__ == "__main__":
    main()
