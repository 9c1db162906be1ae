"""The schema of attributes to CVAT and back: in its XML and in its label constructor's JSON."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from made_tracks import table, through

from tracking.errors import FormatError
from tracking.formats import Filmed, losses
from tracking.formats.cvat import CVAT, import_cvat
from tracking.formats.schema_files import (
    SCHEMA_NAME,
    cvat_json,
    find_schema_file,
    read_schema,
    schema_toml,
    write_schema,
)
from tracking.formats.track_writer import Exported
from tracking.tracks import Attribute, AttributeType, Schema, TrackLabel

ROLE = Attribute("role", AttributeType.CHOICE, ("guest", "staff & co"), "guest")
BAG = Attribute("bag", AttributeType.YES_NO, default="no")
AGE = Attribute("age", AttributeType.NUMBER, least=0, most=120, step=0.5)
COAT = Attribute("coat", default="dark")
SCHEMA = (ROLE, BAG, AGE, COAT)

_names = st.text(st.sampled_from("ab <&é入_'\"\\"), min_size=1, max_size=8).map(str.strip)
names = st.one_of(_names.filter(bool), st.sampled_from(["name", "name_", "track_id", "color"]))
numbers = st.integers(-1000, 1000).map(float)


@st.composite
def attributes(draw: st.DrawFn) -> Attribute:
    """An attribute of any type, with a default or without."""
    name, kind = draw(names), draw(st.sampled_from(AttributeType))
    default = draw(st.booleans())
    if kind is AttributeType.CHOICE:
        choices = tuple(draw(st.lists(names, min_size=1, max_size=5, unique=True)))
        return Attribute(name, kind, choices, choices[-1] if default else "")
    if kind is AttributeType.YES_NO:
        return Attribute(name, kind, default=draw(st.sampled_from(("yes", "no", ""))))
    if kind is AttributeType.NUMBER:
        least, width, step = draw(numbers), draw(st.integers(1, 500)), draw(st.integers(1, 5))
        text = f"{least:g}" if default else ""
        return Attribute(name, kind, (), text, least=least, most=least + width, step=float(step))
    return Attribute(name, kind, default=draw(names) if default else "")


schemas = st.lists(attributes(), max_size=5, unique_by=lambda one: " ".join(one.name.split())).map(
    lambda found: tuple(
        Attribute(" ".join(one.name.split()), one.type, *_rest(one)) for one in found
    )
)


def _rest(one: Attribute) -> tuple[object, ...]:
    choices = tuple(dict.fromkeys(" ".join(choice.split()) for choice in one.choices))
    default = " ".join(one.default.split())
    return choices, default, one.required, one.least, one.most, one.step


def exported(schema: Schema, **labels: TrackLabel) -> Exported:
    made = table([(0, 7), (1, 7)], [(1, 2, 3, 4)] * 2)
    given = {int(track[1:]): label for track, label in labels.items()}
    return Exported.of_table(made, size_px=(640, 480), labels=given, schema=schema)


def meta(*attributes: str, label: str = "person") -> str:
    return (
        f"<meta><task><labels><label><name>{label}</name><attributes>"
        f"{''.join(attributes)}</attributes></label></labels></task></meta>"
    )


def spec(name: str, kind: str = "text", values: str = "", default: str = "") -> str:
    return (
        f"<attribute><name>{name}</name><mutable>True</mutable><input_type>{kind}</input_type>"
        f"<default_value>{default}</default_value><values>{values}</values></attribute>"
    )


def of_xml(folder: Path, head: str, *boxes: str) -> tuple[Schema, tuple[str, ...], TrackLabel]:
    path = folder / "a.xml"
    path.write_text(
        f'<annotations>{head}<track id="7" label="person" source="manual">'
        f"{''.join(boxes) or box(0)}</track></annotations>"
    )
    found = import_cvat(path, Filmed())
    return found.schema, found.notes, found.labels.get(7, TrackLabel())


def box(frame: int, **said: str) -> str:
    inside = "".join(f'<attribute name="{key}">{text}</attribute>' for key, text in said.items())
    return (
        f'<box frame="{frame}" outside="0" occluded="0" keyframe="1" xtl="1" ytl="2" xbr="9" '
        f'ybr="22">{inside}</box>'
    )


def test_schema_and_values_come_back_from_cvat(tmp_path: Path) -> None:
    label = TrackLabel("Ada", {"role": "staff & co", "bag": "yes", "age": "4.5", "own": "text"})
    back = through(CVAT, tmp_path / "t.xml", exported(SCHEMA, t7=label))
    assert back.schema == (*SCHEMA, Attribute("own"))
    assert back.labels == {7: label}
    text = (tmp_path / "t.xml").read_text()
    assert "<input_type>checkbox</input_type><default_value>false</default_value>" in text
    assert '<attribute name="bag">true</attribute>' in text
    assert "<values>guest\nstaff &amp; co</values>" in text


def test_a_default_is_no_value_of_anybody(tmp_path: Path) -> None:
    back = through(CVAT, tmp_path / "t.xml", exported(SCHEMA))
    assert back.labels == {}


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=60
)
@given(schemas)
def test_every_schema_comes_back(tmp_path: Path, schema: Schema) -> None:
    back = through(CVAT, tmp_path / "t.xml", exported(schema)).schema
    plain = all(one == Attribute(one.name) for one in schema)
    assert back == (() if plain else schema)
    for name, text in ((SCHEMA_NAME, schema_toml(schema)), ("labels.json", cvat_json(schema))):
        path = tmp_path / name
        path.write_text(text)
        read = read_schema(path)
        assert read.schema == schema
        assert not read.notes


def test_what_is_required_is_kept_in_toml_and_told_of_cvat(tmp_path: Path) -> None:
    schema = (Attribute("role", AttributeType.CHOICE, ("a", "b"), required=True),)
    write_schema(tmp_path / SCHEMA_NAME, schema)
    assert read_schema(tmp_path / SCHEMA_NAME).schema == schema
    notes = losses(CVAT, exported(schema), tmp_path / "t.xml")
    assert any("role is required and has no value: track 7" in note for note in notes)
    assert any("does not say that an attribute is required" in note for note in notes)


def test_values_that_do_not_suit_are_told_on_export(tmp_path: Path) -> None:
    label = TrackLabel(attributes={"role": "cook", "age": "121", "bag": "perhaps"})
    notes = losses(CVAT, exported(SCHEMA, t7=label), tmp_path / "t.xml")
    assert [note for note in notes if "does not suit" in note] == [
        "attribute role of track 7 does not suit the schema ('cook'): it is one of: guest, staff &"
        " co",
        "attribute bag of track 7 does not suit the schema ('perhaps'): it is one of: yes, no",
        "attribute age of track 7 does not suit the schema ('121'): it is at most 120",
    ]


def test_radio_is_a_choice_and_odd_definitions_are_told(tmp_path: Path) -> None:
    head = meta(
        spec("role", "radio", "a\nb\n\nb", "b"),
        spec("empty", "select", ""),
        spec("odd", "slider", "1"),
        spec("bag", "checkbox", "false", "perhaps"),
    )
    schema, notes, _ = of_xml(tmp_path, head)
    assert schema == (
        Attribute("role", AttributeType.CHOICE, ("a", "b"), "b"),
        Attribute("bag", AttributeType.YES_NO),
    )
    assert [note.split(":")[0] for note in notes] == [
        "attribute empty is not taken into the schema",
        "attribute odd is not taken into the schema",
        "the default 'perhaps' of attribute bag does not suit it and is left out",
    ]


def test_a_value_that_changes_along_a_track_is_told(tmp_path: Path) -> None:
    boxes = (box(0, role="a", name="Ada"), box(1, role="b", name="Ada"))
    _, notes, label = of_xml(tmp_path, meta(spec("role")), *boxes)
    assert label == TrackLabel("Ada", {"role": "a"})
    assert notes == ("attribute role changes along track 7: its first value is taken",)


def test_a_file_of_free_text_has_no_schema(tmp_path: Path) -> None:
    assert of_xml(tmp_path, meta(spec("coat"), spec("track_id")))[0] == ()


def test_labels_that_differ_are_told(tmp_path: Path) -> None:
    one, two = spec("role", "select", "a\nb"), spec("role", "select", "a\nc")
    schema, notes, _ = of_xml(tmp_path, meta(one) + meta(two, label="car").replace("task", "job"))
    assert schema[0].choices == ("a", "b")
    assert notes == ("labels differ in their attribute role: the first is taken",)


def test_a_flood_of_attributes_is_cut_and_told(tmp_path: Path) -> None:
    many = [spec(f"a{number}", "checkbox") for number in range(70)]
    schema, notes, _ = of_xml(tmp_path, meta(*many))
    assert len(schema) == 64
    assert notes == ("too many attributes: a64, a65, a66, a67, a68, a69 are left out",)


def test_a_flood_of_choices_is_refused_by_name(tmp_path: Path) -> None:
    choices = "\n".join(map(str, range(201)))
    schema, (note,), _ = of_xml(tmp_path, meta(spec("role", "select", choices)))
    assert schema == ()
    assert "attribute role has 201 choices; at most 200" in note


def test_the_label_constructors_json_is_read(tmp_path: Path) -> None:
    path = tmp_path / "labels.json"
    path.write_text(
        json.dumps(
            [
                {
                    "name": "person",
                    "id": 3,
                    "color": "#c06060",
                    "type": "rectangle",
                    "attributes": [
                        {
                            "id": 1,
                            "name": "role",
                            "input_type": "select",
                            "mutable": False,
                            "values": ["guest", "staff"],
                            "default_value": "guest",
                        },
                        {"name": "age", "input_type": "number", "values": ["0", "99", "1"]},
                    ],
                },
                {"name": "bag", "attributes": []},
            ]
        )
    )
    assert read_schema(path).schema == (
        Attribute("role", AttributeType.CHOICE, ("guest", "staff"), "guest"),
        Attribute("age", AttributeType.NUMBER, least=0, most=99, step=1),
    )


@pytest.mark.parametrize(
    ("name", "text", "why"),
    [
        ("a.json", "[" * 100_000, "not readable as JSON"),
        ("a.json", "[{]", "not readable as JSON"),
        ("a.json", "[]", "no list of labels"),
        ("a.json", '[{"attributes": []}]', "no list of labels"),
        ("a.json", '[{"name": "person", "attributes": {}}]', "are no list"),
        ("a.json", "x" * ((1 << 20) + 1), "larger than"),
        ("a.toml", "format = 2", "no line format = 1"),
        ("a.toml", "format = 1\nname = 3", "name means nothing here"),
        ("a.toml", "format = 1\nattribute = 3", "a list of at most 64 attributes"),
        ("a.toml", "format = 1\n[[attribute]]\nname = 3", "a table with a name"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a"\nsize = 3', "size means nothing here"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a"\ntype = "list"', "type 'list'"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a"\ntype = "choice"', "needs choices"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a"\nrequired = 1', "wrong type"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a"\nleast = 1', "only a number"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "class"', "choose another"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a\\nb"', "no line of text"),
        ("a.toml", 'format = 1\n[[attribute]]\nname = "a"\n[[attribute]]\nname = "a"', "two"),
        ("a.toml", "a = " + "[" * 100_000, "a.toml"),
    ],
)
def test_a_file_that_is_no_schema_is_refused(
    tmp_path: Path, name: str, text: str, why: str
) -> None:
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(FormatError) as refused:
        read_schema(path)
    assert why in str(refused.value)
    assert "\n" not in str(refused.value)


def test_the_schema_of_a_project_is_found_above_a_session_and_never_by_a_link(
    tmp_path: Path,
) -> None:
    inner = tmp_path / "project" / "day"
    inner.mkdir(parents=True)
    assert find_schema_file(inner) is None
    write_schema(tmp_path / "project" / SCHEMA_NAME, SCHEMA)
    assert find_schema_file(inner) == tmp_path / "project" / SCHEMA_NAME
    (inner / SCHEMA_NAME).symlink_to(tmp_path / "project" / SCHEMA_NAME)
    assert find_schema_file(inner) == tmp_path / "project" / SCHEMA_NAME
    with pytest.raises(FormatError):
        read_schema(inner / SCHEMA_NAME)
