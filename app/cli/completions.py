"""What a shell proposes for names of trackers, settings and formats; see `--show-completion`.

The catalogues are imported when a shell asks, never for a page of help.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

import typer

from tracking.translation import N_, tr

_WIDEST = 50
"""Letters of what is told beside a proposal: shells take a second line of it for another one."""
Proposals = list[tuple[str, str]]
"""What can be typed, each with what it is."""


def complete_trackers(incomplete: str) -> Proposals:
    """Trackers whose names begin as typed."""
    from tracking.trackers import TRACKERS

    return _fitting(((one.name, one.title) for one in TRACKERS.values()), incomplete)


def complete_settings(ctx: typer.Context, incomplete: str) -> Proposals:
    """Settings as KEY=: of the tracker that was typed before, else of all of them."""
    from tracking.trackers import TRACKERS, settings_fields

    named = TRACKERS.get(str(ctx.params.get("tracker")))
    helps = {
        f"{field.name}=": field.help
        for spec in (TRACKERS.values() if named is None else (named,))
        for field in settings_fields(spec.settings_type)
    }
    return _fitting(helps.items(), incomplete)


def complete_export_formats(incomplete: str) -> Proposals:
    """Formats that export writes."""
    from tracking.formats import FORMATS

    known = [(one.name, one.title) for one in FORMATS.values() if one.write is not None]
    parts = (("labels", N_("labels of body parts")), ("samples", N_("samples of body parts")))
    return _fitting((*known, *parts), incomplete)


def complete_import_formats(incomplete: str) -> Proposals:
    """Formats that import reads."""
    from tracking.formats import FORMATS

    known = ((one.name, one.title) for one in FORMATS.values() if one.read is not None)
    return _fitting(known, incomplete)


def _fitting(known: Iterable[tuple[str, str]], incomplete: str) -> Proposals:
    """Those that begin as typed, told in one short line."""
    return [
        (name, textwrap.shorten(tr(said), _WIDEST, placeholder=" ..."))
        for name, said in known
        if name.startswith(incomplete)
    ]
