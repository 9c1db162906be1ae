"""`trackers`: what can be run, with every setting."""

from __future__ import annotations

import shutil
import sys
import textwrap
from typing import Any

from app.cli.output import print_json, print_line, print_lines
from tracking.trackers import TRACKERS, SettingField, TrackerSpec, settings_fields, tracker_named
from tracking.translation import msg


def run_trackers(name: str | None, *, as_json: bool) -> None:
    """Print the catalogue, or one tracker of it. Raises SettingsError for an unknown name."""
    shown = list(TRACKERS.values()) if name is None else [tracker_named(name)]
    if as_json:
        print_json({"trackers": [_as_json(spec) for spec in shown]})
        return
    for number, spec in enumerate(shown):
        source = f" [{spec.paper}]" if spec.paper else ""
        if number:
            print_line()
        print_line(f"{spec.name}  {spec.title}{source}")
        print_line(msg("  needs: {needs}", needs=", ".join(_needs(spec)) or "one camera"))
        fields = settings_fields(spec.settings_type)
        for field in (one for one in fields if not one.expert):
            print_lines(_line(field))
        print_line("  expert settings:")
        for field in (one for one in fields if one.expert):
            print_lines(_line(field))


def _as_json(spec: TrackerSpec) -> dict[str, Any]:
    return {
        "name": spec.name,
        "title": spec.title,
        "paper": spec.paper,
        "needs_stereo": spec.needs_stereo,
        "needs_calibration": spec.needs_calibration,
        "settings": [
            {
                "name": field.name,
                "type": field.type.__name__,
                "default": field.default,
                "unit": field.unit,
                "range": None if field.range is None else list(field.range),
                "help": field.help,
                "expert": field.expert,
            }
            for field in settings_fields(spec.settings_type)
        ],
    }


def _needs(spec: TrackerSpec) -> list[str]:
    asked = (("two cameras", spec.needs_stereo), ("a calibration", spec.needs_calibration))
    return [name for name, needed in asked if needed]


def _line(field: SettingField) -> str:
    limits = (
        msg(", {low:g} to {high:g}", low=field.range[0], high=field.range[1]) if field.range else ""
    )
    value = f"{field.name}={field.default}"
    text = f"  {value:<44} {field.help} ({field.unit or field.type.__name__}{limits})"
    if not sys.stdout.isatty():
        return text  # a line a setting, to be searched
    width = shutil.get_terminal_size().columns
    return "\n".join(textwrap.wrap(text, width, subsequent_indent=" " * 8))
