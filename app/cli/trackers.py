"""`trackers`: what can be run, with every setting."""

from __future__ import annotations

import shutil
import sys
from typing import Any

from app.cli.output import print_json, print_line, print_lines, say
from tracking.text_columns import lines_of
from tracking.trackers import TRACKERS, SettingField, TrackerSpec, settings_fields, tracker_named
from tracking.translation import Message, count_msg, joined, msg, tr

_TYPED = 36
"""Letters of a setting and its default, beside which the help stands."""


def run_trackers(name: str | None, *, expert: bool, as_json: bool) -> None:
    """Print the catalogue, or one tracker of it. Raises SettingsError for an unknown name.

    Args:
        expert: with the expert settings, which JSON always has.
    """
    shown = list(TRACKERS.values()) if name is None else [tracker_named(name)]
    for fault in TRACKERS.faults if name is None else ():
        say(msg("note: {error}", error=fault.error))
    if as_json:
        print_json({"trackers": [_as_json(spec) for spec in shown]})
        return
    for number, spec in enumerate(shown):
        if number:
            print_line()
        _print_tracker(spec, expert=expert)


def _print_tracker(spec: TrackerSpec, *, expert: bool) -> None:
    title = msg(spec.title)
    print_line(
        msg("{name}  {title} [{paper}]", name=spec.name, title=title, paper=spec.paper)
        if spec.paper
        else msg("{name}  {title}", name=spec.name, title=title)
    )
    needs = joined(", ", _needs(spec)) or msg("one camera")
    print_line(msg("  needs: {needs}", needs=needs))
    fields = settings_fields(spec.settings_type)
    more = [field for field in fields if field.expert]
    for field in (one for one in fields if not one.expert):
        print_lines(_line(field))
    if not expert:
        print_line(
            count_msg(
                len(more),
                "  {n} expert setting: trackers {name} --expert",
                "  {n} expert settings: trackers {name} --expert",
                name=spec.name,
            )
        )
        return
    print_line(msg("  expert settings:"))
    for field in more:
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


def _needs(spec: TrackerSpec) -> list[Message]:
    asked = (
        (msg("two cameras"), spec.needs_stereo),
        (msg("a calibration"), spec.needs_calibration),
    )
    return [name for name, needed in asked if needed]


def _line(field: SettingField) -> str:
    """As `--set` takes it, what it does, and what values it may have."""
    default = str(field.default).lower() if field.type is bool else str(field.default)
    typed = f"{field.name}={default}"
    values = _values(field)
    text = f"  {typed:<{_TYPED}} {tr(field.help)}" + (f" ({tr(values)})" if values else "")
    if not sys.stdout.isatty():
        return text  # a line a setting, to be searched
    width = shutil.get_terminal_size().columns
    return "\n".join(lines_of(text, width, " " * 8))


def _values(field: SettingField) -> Message:
    """The values that it takes, with their unit; "" for any text."""
    if field.type is bool:
        return msg("true or false")
    unit = msg(field.unit)
    if field.range is None:
        return unit
    low, high = field.range
    if not field.unit:
        return msg("{low:g} to {high:g}", low=low, high=high)
    return msg("{low:g} to {high:g} {unit}", low=low, high=high, unit=unit)
