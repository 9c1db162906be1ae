"""What plug-ins are, as a digest: another version or another code gives another one."""

from __future__ import annotations

import hashlib
import importlib.util
from collections.abc import Iterable, Iterator
from pathlib import Path

from tracking.plugins.kind import PluginKind
from tracking.plugins.offers import OWN, Offer, offers_of


def plugin_digests(asked: Iterable[tuple[PluginKind, str]]) -> list[list[str]]:
    """Kind, name, package, version and digest of the code of each plug-in that is asked for.

    Names that no plug-in offers give nothing. Nothing is imported, but the packages around a module
    that is in one. Raises OSError where code cannot be read.
    """
    return [
        [str(kind), name, offer.package, offer.version, _code_digest(offer)]
        for kind, name in asked
        for offer in offers_of(kind, {})
        if offer.name == name and offer.package != OWN
    ]


def _code_digest(offer: Offer) -> str:
    digest = hashlib.sha256()
    for file in _code_files(offer.module.partition(".")[0]):
        digest.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def _code_files(module: str) -> Iterator[Path]:
    """The Python files of a top module, or of all in it; none where it cannot be found."""
    try:
        spec = importlib.util.find_spec(module)
    except (ImportError, ValueError):
        return
    if spec is None:
        return
    for place in spec.submodule_search_locations or ():
        yield from sorted(Path(place).rglob("*.py"))
    if spec.submodule_search_locations is None and spec.origin is not None:
        yield from (file for file in (Path(spec.origin),) if file.is_file())
