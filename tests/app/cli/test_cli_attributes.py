"""`attributes`, and what import and export say of them."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.editing import plan_set_attribute
from tracking.session import Session

ATTRIBUTES = """format = 1

[[attribute]]
name = "role"
type = "choice"
choices = ["guest", "staff"]
default = "guest"

[[attribute]]
name = "bag"
type = "yes-no"
"""


@pytest.fixture
def schema(tmp_path: Path) -> Path:
    path = tmp_path / "attributes.toml"
    path.write_text(ATTRIBUTES)
    return path


def _say(session: Path, key: str, value: str) -> int:
    with closing(Session.open(session)) as own:
        track = own.tracks.track_ids[0]
        own.apply(plan_set_attribute(own.tracks, own.labels, track, key, value))
        own.save()
    return track


def test_a_schema_is_taken_as_one_edit_and_printed(
    trackwright: Trackwright, session: Path, schema: Path
) -> None:
    track = _say(session, "role", "cook")
    status, printed, said = trackwright("attributes", session, "--take", schema)
    assert status == 0
    assert printed == "role: choice of guest, staff, default guest\nbag: yes or no\n"
    assert f"attribute role of track {track} does not suit the schema ('cook')" in said
    with closing(Session.open(session)) as own:
        assert [one.name for one in own.labels.schema] == ["role", "bag"]
        own.undo()
        assert own.labels.schema == ()


def test_a_schema_goes_to_cvats_label_constructor_and_back(
    trackwright: Trackwright, session: Path, schema: Path, tmp_path: Path
) -> None:
    made, again = tmp_path / "labels.json", tmp_path / "again.toml"
    assert trackwright("attributes", session, "--take", schema, "-o", made)[0] == 0
    (label,) = json.loads(made.read_text())
    assert [one["name"] for one in label["attributes"]] == ["track_id", "name", "role", "bag"]
    status, _, said = trackwright("attributes", session, "--take", made)
    assert (status, "nothing to change" in said) == (1, True)
    assert trackwright("attributes", session, "-o", again)[0] == 0
    assert again.read_text() == ATTRIBUTES


def test_cvat_brings_schema_and_values_into_a_new_session(
    trackwright: Trackwright, session: Path, schema: Path, tmp_path: Path
) -> None:
    track = _say(session, "bag", "yes")
    trackwright("attributes", session, "--take", schema)
    schema.unlink()
    made, new = tmp_path / "t.xml", tmp_path / "new.h5"
    assert trackwright("export", session, "-o", made, "--format", "cvat")[0] == 0
    with closing(Session.look_into(session)) as own:
        recording = (session.parent / own.recording.path).resolve()
    status, _, said = trackwright("import", made, "--recording", recording, "-o", new)
    assert status == 0
    assert "the session does now: role, bag" in said
    with closing(Session.look_into(new)) as own:
        assert [one.name for one in own.labels.schema] == ["role", "bag"]
        assert own.labels.of_track(track).attributes == {"bag": "yes"}


def test_the_projects_schema_is_that_of_new_sessions_and_conflicts_are_told(
    trackwright: Trackwright, session: Path, schema: Path, tmp_path: Path
) -> None:
    trackwright("attributes", session, "--take", schema)
    made, new = tmp_path / "t.xml", tmp_path / "new.h5"
    track = _say(session, "role", "staff")
    assert trackwright("export", session, "-o", made, "--format", "cvat")[0] == 0
    schema.write_text(ATTRIBUTES.replace('"staff"', '"visitor"'))
    with closing(Session.look_into(session)) as own:
        recording = (session.parent / own.recording.path).resolve()
    status, _, said = trackwright("import", made, "--recording", recording, "-o", new)
    assert status == 0
    assert (
        "attribute role: the file says choice of guest, staff, default guest, the session choice of"
        " guest, visitor, default guest, which stays" in said
    )
    assert f"attribute role of track {track} does not suit the schema ('staff')" in said
    with closing(Session.look_into(new)) as own:
        assert own.labels.schema[0].choices == ("guest", "visitor")
        assert own.labels.of_track(track).attributes["role"] == "staff"


def test_what_is_no_schema_is_refused_in_a_line(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    bad = tmp_path / "bad.toml"
    bad.write_text("format = 1\n[[attribute]]\nname = 1\n")
    status, _, said = trackwright("attributes", session, "--take", bad)
    assert status == 1
    assert "an attribute is a table with a name" in said
