"""Settings under the names that they had before they were renamed, as sessions hold them.

`tests/golden/settings/before-renaming.json` holds the defaults of all trackers as the last version
with these names wrote them.
"""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

import pytest

from tracking.detections import DetectionSettings
from tracking.errors import SettingsError
from tracking.settings import former_names
from tracking.trackers import (
    TRACKERS,
    changed_settings,
    parse_settings,
    present_settings,
    settings_fields,
    settings_from,
)

GOLDEN = Path(__file__).parents[1] / "golden" / "settings" / "before-renaming.json"
KEPT: dict[str, dict[str, Any]] = json.loads(GOLDEN.read_text())
DETECTIONS = frozenset(
    f"detections.{field.name}" for field in dataclasses.fields(DetectionSettings)
)
CAME_LATER = {"three-part": {"smooth"}, "three-part-joint": {"smooth"}}
"""Settings there were none of before, beside `DETECTIONS` of all trackers."""
CHANGED = {"spheroid": {"max_spread_m": 1.5}}
"""Defaults that are others now; runs of before keep theirs."""
FORMER = [
    (name, former, present)
    for name, spec in TRACKERS.items()
    if name in KEPT  # others came later
    for former, present in former_names(spec.settings_type).items()
]


@pytest.mark.parametrize("name", KEPT)
def test_the_defaults_of_an_earlier_version_are_the_defaults(name: str) -> None:
    spec = TRACKERS[name]
    present = present_settings(name, KEPT[name])
    known = {field.name for field in settings_fields(spec.settings_type)}
    assert present.keys() == known - DETECTIONS - CAME_LATER.get(name, set())
    changed = CHANGED.get(name, {})
    assert settings_from(spec.settings_type, present | changed) == spec.settings_type()
    assert changed_settings(name, present).keys() == changed.keys()


@pytest.mark.parametrize(("name", "former", "present"), FORMER)
def test_a_kept_value_is_that_of_the_renamed_setting(name: str, former: str, present: str) -> None:
    other = _another(KEPT[name][former])
    kept = present_settings(name, {**KEPT[name], former: other})
    kept |= {key: value for key, value in CHANGED.get(name, {}).items() if key != present}
    assert changed_settings(name, kept) == {present: other}


@pytest.mark.parametrize(("name", "former", "present"), FORMER)
def test_who_sets_a_former_name_is_told_the_present_one(
    name: str, former: str, present: str
) -> None:
    with pytest.raises(SettingsError) as error:
        parse_settings(TRACKERS[name], {former: "1"})
    assert str(error.value) == f"setting {former} is unknown: its name is {present} now"


@pytest.mark.parametrize("name", TRACKERS)
def test_a_former_name_is_no_present_one_and_leads_to_one_setting(name: str) -> None:
    fields = settings_fields(TRACKERS[name].settings_type)
    former = [each for field in fields for each in field.formerly]
    assert len(former) == len(set(former))
    assert not set(former) & {field.name for field in fields}


def test_of_a_former_name_that_only_others_have_both_are_said() -> None:
    with pytest.raises(SettingsError) as error:
        parse_settings(TRACKERS["spheroid"], {"agility": "1"})
    assert str(error.value) == (
        "spheroid has no setting agility, whose name is process_noise now (stereo-joint has it): "
        "choose such a tracker with --tracker, or leave the setting out"
    )


def test_settings_of_a_tracker_that_is_not_known_stay_as_they_are() -> None:
    assert present_settings("of-tomorrow", {"agility": 3.0}) == {"agility": 3.0}


def _another(value: Any) -> Any:
    return not value if isinstance(value, bool) else 2 * value + 1
