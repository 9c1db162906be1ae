from __future__ import annotations

import dataclasses
import json
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.errors import SettingsError
from tracking.trackers import (
    TRACKERS,
    changed_settings,
    occluders_as_setting,
    parse_settings,
    settings_fields,
    settings_from,
    settings_values,
)

SPEC = TRACKERS["stereo-direction"]
ALL = [(spec, field) for spec in TRACKERS.values() for field in settings_fields(spec.settings_type)]

NOT_OUR_WORDS = {"somebody", "nobody", "whoever", "guess", "newcomer", "newcomers", "looks"} | {
    *("sighting", "sightings", "eye", "eyes", "picture", "pictures", "remembered", "shown"),
}
"""There are words of the field for what these say: person, tentative track, detection, camera."""


@pytest.mark.parametrize(("spec", "field"), ALL, ids=lambda value: getattr(value, "name", ""))
def test_every_setting_is_described_and_its_default_allowed(spec, field):
    assert field.help
    assert field.help == field.help.strip(". ")
    settings_from(spec.settings_type, {field.name: field.default})


@pytest.mark.parametrize(("spec", "field"), ALL, ids=lambda value: getattr(value, "name", ""))
def test_help_says_what_a_setting_is_and_what_other_values_do_in_the_fields_words(spec, field):
    assert field.help[0].isupper(), spec.name
    words = set(re.findall(r"[a-z]+", field.help.lower()))
    assert not words & NOT_OUR_WORDS
    if field.type is bool:
        assert "Off" in field.help or "without our additions" in field.help
    elif field.type is not str:
        assert "higher: " in field.help or "lower: " in field.help


@pytest.mark.parametrize(("spec", "field"), ALL, ids=lambda value: getattr(value, "name", ""))
def test_every_setting_can_be_read_back_from_its_text(spec, field):
    settings = parse_settings(spec, {field.name: str(field.default)})
    assert settings == spec.settings_type()


def test_text_sets_a_value_of_its_type():
    settings = parse_settings(SPEC, {"particles": "250", "gate_m": " 1.5 "})
    assert (settings.particles, settings.gate_m) == (250, 1.5)


def test_a_dotted_name_sets_a_value_of_an_earlier_stage():
    name = next(f.name for f in settings_fields(SPEC.settings_type) if f.name.startswith("people."))
    default = settings_values(SPEC.settings_type())[name]
    settings = parse_settings(SPEC, {name: str(default)})
    assert getattr(settings.people, name.removeprefix("people.")) == default


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        ({"particels": "5"}, "particles"),
        ({"particles": "5"}, "from 10 to 20000"),
        ({"particles": "many"}, "a whole number"),
        ({"particles": "500.5"}, "a whole number"),
        ({"gate_m": "nan"}, "from 0.1 to 5 m"),
        ({"stereo.window_px": "8"}, "an odd number from 5 to 31 px"),
        ({"qqqqqqq": "1"}, "lists all settings"),
    ],
)
def test_what_cannot_be_set_is_said_in_one_line(texts, said):
    with pytest.raises(SettingsError) as error:
        parse_settings(SPEC, texts)
    assert said in str(error.value)
    assert next(iter(texts)) in str(error.value)
    assert "\n" not in str(error.value)


def test_of_a_setting_that_only_others_have_it_is_said_who():
    with pytest.raises(SettingsError) as error:
        parse_settings(TRACKERS["stereo-joint"], {"paper": "true"})
    assert str(error.value).startswith("stereo-joint has no setting paper (")
    assert "stereo-direction, stereo-colour" in str(error.value)
    assert "--tracker" in str(error.value)
    assert "\n" not in str(error.value)


@given(st.integers(10, 20000), st.floats(0.1, 5.0))
def test_values_make_the_settings_they_came_from_even_through_json(particles, gate_m):
    settings = settings_from(SPEC.settings_type, {"particles": particles, "gate_m": gate_m})
    values = json.loads(json.dumps(settings_values(settings)))
    assert settings_from(SPEC.settings_type, values) == settings


def test_settings_cannot_be_changed():
    with pytest.raises(dataclasses.FrozenInstanceError):
        SPEC.settings_type().particles = 3


@pytest.mark.parametrize("nothing", ["", "[]", occluders_as_setting([])])
def test_no_occluders_are_no_change_of_a_setting(nothing):
    assert changed_settings("spheroid", {"occluders": nothing}) == {}
    drawn = "[[[1, 1], [2, 1], [2, 2]]]"
    assert changed_settings("spheroid", {"occluders": drawn}) == {"occluders": drawn}


def test_no_title_names_the_unit_that_stands_beside_the_number():
    titles = {field.name: field.title for _, field in ALL}
    assert titles["process_noise_m"] == "Process noise"
    for name, title in titles.items():
        assert title.rpartition(" ")[2] not in ("m", "s", "px", "deg", "rad"), name
