"""`plugins`: what is offered by whom, and a package to begin with."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import typer

import tracking
from app.cli.output import print_json, print_line, print_table
from app.cli.plugin_package import PluginPackage, make_package, named_rightly
from tracking.detections.catalogue import DETECTORS
from tracking.errors import PluginError
from tracking.formats import FORMATS
from tracking.plugins import WITHOUT, Catalogue, Offer, PluginKind
from tracking.plugins.offers import offers_state
from tracking.recording.kinds.catalogue import KINDS
from tracking.trackers import TRACKERS
from tracking.translation import joined, msg

CATALOGUES: Mapping[PluginKind, Catalogue[Any]] = {
    PluginKind.TRACKER: TRACKERS,
    PluginKind.FORMAT: FORMATS,
    PluginKind.RECORDING: KINDS,
    PluginKind.DETECTOR: DETECTORS,
}
"""All kinds, in the order in which they are listed."""


@dataclass(frozen=True, slots=True)
class Plugin:
    """One line of the list: what is offered, and why it does not work; None: it works."""

    offer: Offer
    error: PluginError | None = None

    @property
    def package(self) -> str:
        """Where it comes from, with its version."""
        version = tracking.__version__ if self.offer.built_in else self.offer.version
        return " ".join(filter(None, (self.offer.package, version)))


def run_plugins(*, as_json: bool) -> None:
    """Print everything that is offered by where it comes from; plug-ins are tried out."""
    found = list(find_plugins())
    if as_json:
        print_json({"plugins": [_as_json(one) for one in found]})
        return
    packages = dict.fromkeys(one.package for one in found)
    for number, package in enumerate(packages):
        if number:
            print_line()
        _print_package(package, [one for one in found if one.package == package])
    if not offers_state()[1]:
        print_line()
        print_line(msg("{variable}=off: plug-ins are left out", variable=WITHOUT))
    elif len(packages) == 1:
        print_line()
        print_line(msg("no plug-ins are installed; make one: trackwright plugins new tracker NAME"))


def find_plugins() -> Iterator[Plugin]:
    """What is built in, then everything of plug-ins, loaded to see whether it works."""
    offers = [(each, offer) for each in CATALOGUES.values() for offer in each.offers]
    for catalogue, offer in sorted(offers, key=lambda pair: _order(pair[1])):
        error = None
        if not offer.built_in:
            try:
                catalogue.load(offer)
            except PluginError as problem:
                error = problem
        yield Plugin(offer, error)


def _order(offer: Offer) -> tuple[bool, str]:
    return (not offer.built_in, "" if offer.built_in else offer.package)


def _print_package(package: str, found: list[Plugin]) -> None:
    print_line(msg("{package}, built in", package=package) if found[0].offer.built_in else package)
    rows: list[tuple[str, object]] = []
    for kind in CATALOGUES:
        names = [one.offer.name for one in found if one.offer.kind is kind and one.error is None]
        if names:
            rows.append((f"  {kind.value}", joined(", ", names)))
    for one in found:
        if one.error is not None:
            why = msg("{name} DOES NOT WORK: {why}", name=one.offer.name, why=one.error.message)
            rows.append((f"  {one.offer.kind.value}", why))
    print_table(rows)


def _as_json(one: Plugin) -> dict[str, Any]:
    offer = one.offer
    return {
        "kind": offer.kind.value,
        "name": offer.name,
        "package": offer.package,
        "version": tracking.__version__ if offer.built_in else offer.version,
        "built_in": offer.built_in,
        "target": offer.target,
        "works": one.error is None,
        "error": "" if one.error is None else str(one.error),
    }


def wanted_package(new: str, kind: str | None, name: str | None) -> PluginPackage:
    """What is to be made, as typed. Raises BadParameter where that is not known or no name."""
    if new != "new":
        raise typer.BadParameter(
            msg("{word!r} is unknown; the only one is new: plugins new KIND NAME", word=new),
            param_hint="plugins",
        )
    kinds = [one.value for one in PluginKind]
    if kind not in kinds:
        raise typer.BadParameter(
            msg("name what to make: {kinds}", kinds=joined(", ", kinds)), param_hint="KIND"
        )
    if name is None or not named_rightly(name):
        raise typer.BadParameter(
            msg("give a name of small letters and digits, with hyphens between, e.g. my-tracker"),
            param_hint="NAME",
        )
    if name in CATALOGUES[PluginKind(kind)].names:
        raise typer.BadParameter(
            msg("there is a {kind} {name} already; choose another name", kind=kind, name=name),
            param_hint="NAME",
        )
    return PluginPackage(PluginKind(kind), name)


def run_new(package: PluginPackage, folder: Path, *, as_json: bool) -> None:
    """Make a package and print what to do next. Raises OutputError where it cannot be written."""
    place = make_package(package, folder)
    if as_json:
        files = sorted(str(file) for file in place.rglob("*") if file.is_file())
        print_json({"package": str(place), "files": files})
        return
    print_line(place)
    print_line(msg('next: pip install -e "{place}[dev]", then pytest "{place}"', place=place))
