"""Which settings of a tracker are offered to everybody, which on request, and which not at all."""

import dataclasses

import pytest

from tracking.errors import SettingsError
from tracking.settings import settings_fields
from tracking.trackers import TRACKERS, parse_settings, present_settings

MOST = 20
"""More would not be read."""


@pytest.mark.parametrize("name", TRACKERS)
def test_a_tracker_offers_at_most_twenty_settings(name):
    fields = settings_fields(TRACKERS[name].settings_type)
    assert 1 <= sum(not field.expert for field in fields) <= MOST


@pytest.mark.parametrize("name", TRACKERS)
def test_what_a_tracker_does_not_use_is_a_setting_of_the_stage(name):
    settings = TRACKERS[name].settings_type()
    for field in dataclasses.fields(settings):
        inner = getattr(settings, field.name)
        if dataclasses.is_dataclass(inner):
            offered = {one.name for one in settings_fields(type(inner))}
            assert set(field.metadata["unused"]) <= offered


@pytest.mark.parametrize(
    ("name", "unused"),
    [
        ("spheroid", "foreground.shadow_threshold"),
        ("spheroid", "foreground.shadow_darkest"),
        ("flow", "foreground.shadow_texture"),
        ("three-part", "people.min_area_m2"),
        ("stereo-joint", "foreground.learn_s"),
    ],
)
def test_a_setting_that_a_tracker_does_nothing_with_is_refused_and_read_in_older_sessions(
    name, unused
):
    spec = TRACKERS[name]
    assert unused not in {field.name for field in settings_fields(spec.settings_type)}
    with pytest.raises(SettingsError, match=f"{unused}"):
        parse_settings(spec, {unused: "0.4"})
    assert present_settings(name, {unused: 0.4, "particles": 7}) == {"particles": 7}


def test_a_tracker_that_does_not_use_a_setting_names_those_that_do():
    with pytest.raises(SettingsError) as error:
        parse_settings(TRACKERS["flow"], {"foreground.floor_shadow_threshold": "0.4"})
    assert "flow has no setting foreground.floor_shadow_threshold (stereo-joint" in str(error.value)
