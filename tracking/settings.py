"""Settings told by their dataclass, read from text, checked at the door.

The settings of a tracker, or of counting, are a frozen dataclass of `tracking.setting.setting`
fields.
A field may itself be such a dataclass (the settings of an earlier stage); its fields are then
named with a dot, e.g. `people.least_height_m`. The form, the command line and the checks below
all come from that one description.
"""

from __future__ import annotations

import dataclasses
import difflib
import math
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Final, get_type_hints

from tracking.errors import SettingsError
from tracking.setting import RESULT
from tracking.translation import msg

SettingValue = bool | int | float | str


@dataclass(frozen=True, slots=True)
class SettingField:
    """One setting, described for a form, the command line or a page of documentation.

    Attributes:
        name: dotted where it belongs to an earlier stage.
        type: bool, int, float or str.
        default: in force where nothing else is asked for.
        unit: "" for a pure number.
        range: lowest and highest value allowed; None where any will do.
        help: one line.
        odd: whether even numbers are refused.
        formerly: names it had in earlier versions, dotted like `name`.
        group: the heading it stands under.
        expert: whether it is shown on request only.
    """

    name: str
    type: type
    default: SettingValue
    unit: str
    range: tuple[float, float] | None
    help: str
    odd: bool = False
    formerly: tuple[str, ...] = ()
    group: str = RESULT
    expert: bool = False

    @property
    def title(self) -> str:
        """The name in words, without its stage and the unit's suffix."""
        name = self.name.rpartition(".")[2]
        unit = self.unit.lower()
        # The suffix may be of the first unit alone: process_noise_m is in m/sqrt(s).
        for suffix in filter(None, (unit.replace("/", "_"), unit.partition("/")[0])):
            if name.endswith(f"_{suffix}"):
                name = name.removesuffix(f"_{suffix}")
                break
        return name.replace("_", " ").capitalize()


def stage_title(stage: str) -> str:
    """The dotted name of a stage in words, e.g. "Foreground / shadows"."""
    return stage.replace(".", " / ").replace("_", " ").capitalize()


def settings_fields(settings_type: type) -> list[SettingField]:
    """Every setting of a settings dataclass, those of nested stages with dotted names."""
    return list(_fields(settings_type(), ""))


def settings_values(settings: Any) -> dict[str, SettingValue]:
    """The settings in force by their (dotted) names: plain JSON values, as a run keeps them."""
    return {field.name: field.default for field in _fields(settings, "")}


def former_names(settings_type: type) -> dict[str, str]:
    """The present name of each setting by the (dotted) names it had in earlier versions."""
    fields = settings_fields(settings_type)
    return {former: field.name for field in fields for former in field.formerly}


def with_present_names(settings_type: type, values: Mapping[str, Any]) -> dict[str, Any]:
    """Values that were kept under former names, under the present ones.

    A value that is there under both names is the present name's. Settings of a stage that the
    tracker does nothing with, and was given by earlier versions, are left out. Names of no setting
    stay.
    """
    unused = _unused_names(settings_type)
    values = {name: value for name, value in values.items() if name not in unused}
    present = former_names(settings_type)
    renamed = {present[name]: value for name, value in values.items() if name in present}
    return renamed | {name: value for name, value in values.items() if name not in present}


def settings_from(settings_type: type, values: Mapping[str, Any]) -> Any:
    """The settings with some values replaced; raises `SettingsError` as `settings_from_text`."""
    known = {field.name: field for field in settings_fields(settings_type)}
    for name, value in values.items():
        if name not in known:
            raise _unknown(name, settings_type)
        _check(known[name], value)
    return _replaced(settings_type(), dict(values))


def settings_from_text(settings_type: type, texts: Mapping[str, str]) -> Any:
    """The settings with some values replaced by what the texts say.

    Raises `SettingsError`: the name is unknown, the text is no value of its type, or it is out
    of range; the message names the setting, what came and what is allowed.
    """
    known = {field.name: field for field in settings_fields(settings_type)}
    values: dict[str, SettingValue] = {}
    for name, text in texts.items():
        if name not in known:
            raise _unknown(name, settings_type)
        values[name] = _parsed(known[name], text.strip())
    return settings_from(settings_type, values)


def _unused_names(settings_type: type) -> set[str]:
    """Dotted names, former ones too, of settings of stages that the tracker does nothing with."""
    return {
        f"{stage.name}.{name}"
        for stage in dataclasses.fields(settings_type)
        if "unused" in stage.metadata
        for field in _fields(getattr(settings_type(), stage.name), "")
        if field.name in stage.metadata["unused"]
        for name in (field.name, *field.formerly)
    }


def _fields(settings: Any, prefix: str, unused: Container[str] = ()) -> Iterator[SettingField]:
    """The settings of one stage, but for the `unused` ones, and of those before it."""
    hints = get_type_hints(type(settings))
    for field in dataclasses.fields(settings):
        value, about = getattr(settings, field.name), field.metadata
        if dataclasses.is_dataclass(value):
            yield from _fields(value, f"{prefix}{field.name}.", about.get("unused", ()))
            continue
        if field.name in unused:
            continue
        hint = hints[field.name]
        kind = hint if hint in (bool, int, float, str) else type(value)
        allowed = about.get("range")
        yield SettingField(
            prefix + field.name,
            kind,
            value,
            about.get("unit", ""),
            allowed,
            about.get("help", ""),
            about.get("odd", False),
            tuple(prefix + former for former in about.get("formerly", ())),
            about.get("group", RESULT),
            about.get("expert", False),
        )


def _replaced(settings: Any, values: Mapping[str, Any]) -> Any:
    """A copy of the settings with dotted values put in."""
    changes: dict[str, Any] = {}
    for field in dataclasses.fields(settings):
        inner = f"{field.name}."
        nested = {k.removeprefix(inner): v for k, v in values.items() if k.startswith(inner)}
        if nested:
            changes[field.name] = _replaced(getattr(settings, field.name), nested)
        elif field.name in values:
            changes[field.name] = values[field.name]
    return dataclasses.replace(settings, **changes)


def _parsed(field: SettingField, text: str) -> SettingValue:
    words = {"true": True, "yes": True, "on": True, "1": True}
    words |= {"false": False, "no": False, "off": False, "0": False}
    try:
        return words[text.lower()] if field.type is bool else field.type(text)
    except (KeyError, ValueError):
        raise _misfit(field, text, _KINDS[field.type]) from None


def _check(field: SettingField, value: Any) -> None:
    if field.type in (int, float) and not isinstance(value, bool):
        fits = isinstance(value, int) or (field.type is float and isinstance(value, float))
    else:
        fits = type(value) is field.type
    fits = fits and not (field.odd and value % 2 == 0)
    low, high = field.range or (-math.inf, math.inf)
    if not fits or (isinstance(value, int | float) and not low <= value <= high):
        kind = field.type.__name__ if field.type in (bool, str) else _KINDS[field.type]
        raise _misfit(field, value, msg("an odd number") if field.odd else kind)


_KINDS: Final = {
    bool: msg("true or false"),
    int: msg("a whole number"),
    float: msg("a number"),
}


def _misfit(field: SettingField, value: object, kind: str) -> SettingsError:
    low, high = field.range or (0.0, 0.0)
    return SettingsError(
        "setting {name}={value}: must be {kind} from {low:g} to {high:g}{unit}"
        if field.range
        else "setting {name}={value}: must be {kind}",
        name=field.name,
        value=value,
        kind=kind,
        low=low,
        high=high,
        unit=f" {field.unit}" if field.unit else "",
    )


def _unknown(name: str, settings_type: type) -> SettingsError:
    present = former_names(settings_type)
    if name in present:
        return SettingsError(
            "setting {name} is unknown: its name is {present} now", name=name, present=present[name]
        )
    known = [field.name for field in settings_fields(settings_type)]
    near = difflib.get_close_matches(name, known, n=1, cutoff=0.4)
    return SettingsError(
        "setting {name} is unknown: did you mean {near}?"
        if near
        else "setting {name} is unknown: the trackers command lists all settings",
        name=name,
        near=near[0] if near else "",
    )
