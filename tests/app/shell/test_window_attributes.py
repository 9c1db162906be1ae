"""The schema of attributes in the real window: fields, digit keys, the dialog."""

import cv2
import numpy as np
import pytest
from correcting_window import SHIFT, Hands, open_for_correcting
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit

from app.core.widgets.number_boxes import NumberBox
from app.features.correction.attribute_controller import AttributeController, schema_notes
from app.features.correction.schema_dialog import SchemaDialog
from tracking.editing import SchemaChange
from tracking.formats.schema_files import read_schema, write_schema
from tracking.tracks import Attribute, AttributeType

Key = Qt.Key
ROLE = Attribute("role", AttributeType.CHOICE, ("guest", "staff"), "guest")
BAG = Attribute("bag", AttributeType.YES_NO)
AGE = Attribute("age", AttributeType.NUMBER, least=0, most=99, step=1)
COAT = Attribute("coat", required=True)
SCHEMA = (ROLE, BAG, AGE, COAT)


@pytest.fixture
def folder(tmp_path):
    """Two seconds of nothing, filmed by one camera."""
    folder = tmp_path / "one-camera"
    folder.mkdir()
    for number in range(20):
        assert cv2.imwrite(str(folder / f"{number:03d}.png"), np.full((96, 128, 3), 90, np.uint8))
    (folder / "recording.toml").write_text(
        'format = 1\nname = "one camera"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    )
    return folder


@pytest.fixture
def hands(window, qtbot, folder) -> Hands:
    """A person who was drawn, and is selected."""
    hands = Hands(window, open_for_correcting(window, qtbot, folder, 2), qtbot)
    for box in ((10.0, 10.0, 20.0, 40.0), (60.0, 10.0, 20.0, 40.0)):
        hands.controller.document.selection.choose(0)
        hands.controller.editing.put_box(box)
        hands.controller.editing.confirm()
    hands.controller.document.selection.choose(1)
    return hands


@pytest.fixture
def described(hands) -> Hands:
    hands.controller.describing.change(SchemaChange(SCHEMA))
    return hands


def _said(hands, track: int = 1) -> dict[str, str]:
    return dict(hands.controller.document.label(track).attributes)


def _field(hands, kind, name: str):
    found = hands.window.workspace.card.findChildren(kind)
    return next(one for one in found if one.accessibleName().startswith(name))


def test_each_type_has_its_control_and_a_default_is_said_of_nobody(described):
    assert _field(described, QComboBox, "role").currentText() == "not said; default guest"
    bag = _field(described, QCheckBox, "bag")
    assert (bag.checkState(), bag.text()) == (Qt.CheckState.PartiallyChecked, "not said")
    assert _field(described, NumberBox, "age").text() == "not said"
    assert _field(described, QLineEdit, "coat, required").placeholderText() == "not said"
    assert _said(described) == {}


def test_controls_give_values_as_edits(described):
    role = _field(described, QComboBox, "role")
    role.activated.emit(2)
    _field(described, QCheckBox, "bag").click()
    age = _field(described, NumberBox, "age")
    age.setFocus()
    age.selectAll()
    QTest.keyClicks(age, "41")
    QTest.keyClick(age, Key.Key_Return)
    coat = _field(described, QLineEdit, "coat")
    coat.setText("red")
    coat.editingFinished.emit()
    assert _said(described) == {"role": "staff", "bag": "yes", "age": "41", "coat": "red"}
    for _ in range(4):
        assert described.controller.editing.undo()
    assert _said(described) == {}


def test_a_value_is_taken_back_by_not_said(described):
    described.controller.describing.give(1, "role", "staff")
    _field(described, QComboBox, "role").activated.emit(0)
    assert _said(described) == {}


def test_values_of_others_complete_a_text(described):
    describing = described.controller.describing
    for track in (1, 2):
        describing.give(track, "coat", "red")
    completer = _field(described, QLineEdit, "coat").completer()
    assert completer.model().index(0, 0).data() == "red"


def test_a_value_that_does_not_suit_is_told_beside_it(described):
    described.controller.describing.give(1, "role", "cook")
    assert _field(described, QComboBox, "role").currentText() == "cook"
    texts = [row.why.text() for row in described.window.workspace.card._form._rows]
    assert texts[0] == "cook: it is one of: guest, staff"


def test_own_attributes_stay_beside_those_of_the_schema(described):
    describing = described.controller.describing
    describing.give(1, "role", "staff")
    describing.set_own(1, (("hat", "blue"),))
    assert _said(described) == {"role": "staff", "hat": "blue"}
    assert described.window.workspace.card._attributes.pairs() == (("hat", "blue"),)
    describing.set_own(1, ())
    assert _said(described) == {"role": "staff"}


def test_digit_keys_set_the_active_attribute_and_nothing_else(described):
    described.press(Key.Key_M, SHIFT)
    described.press(Key.Key_2)
    assert _said(described) == {"role": "staff"}
    assert described.window.meter.text().startswith("Keys 1 to 2 set role")
    described.press(Key.Key_M, SHIFT)
    described.press(Key.Key_1)
    assert _said(described) == {"role": "staff", "bag": "yes"}
    described.press(Key.Key_M, SHIFT)
    assert described.controller.describing.active is None
    described.press(Key.Key_2)
    assert _said(described) == {"role": "staff", "bag": "yes"}


def test_digits_in_a_field_are_typed(described):
    described.press(Key.Key_M, SHIFT)
    coat = _field(described, QLineEdit, "coat")
    coat.setFocus()
    QTest.keyClicks(coat, "2")
    assert coat.text() == "2"
    assert _said(described) == {}


def _dialog(hands) -> SchemaDialog:
    hands.controller.describing.ask_schema()
    (dialog,) = hands.window.findChildren(SchemaDialog)
    hands.qtbot.waitUntil(dialog.isVisible)
    return dialog


def test_the_dialog_makes_a_schema_in_one_edit(hands):
    edits = len(hands.controller.document.session.history)
    dialog = _dialog(hands)
    dialog.add.click()
    dialog.name.setText("role")
    dialog.name.textEdited.emit("role")
    dialog.type.setCurrentIndex(dialog.type.findData(AttributeType.CHOICE))
    dialog.type.activated.emit(0)
    assert not dialog.ok.isEnabled()
    assert dialog.told.text() == "attribute role: a choice needs choices; add some"
    dialog.choices.setPlainText("guest\nstaff\n")
    dialog.default.setText("guest")
    dialog.default.textEdited.emit("guest")
    assert dialog.ok.isEnabled()
    dialog.ok.click()
    assert hands.controller.document.session.labels.schema == (ROLE,)
    assert len(hands.controller.document.session.history) == edits + 1
    assert hands.controller.editing.undo()
    assert hands.controller.document.session.labels.schema == ()


def test_the_dialog_says_what_becomes_of_values(described):
    describing = described.controller.describing
    describing.give(1, "role", "guest")
    describing.give(1, "bag", "yes")
    dialog = _dialog(described)
    dialog.name.setText("duty")
    dialog.name.textEdited.emit("duty")
    dialog.choices.setPlainText("visitor\nstaff")
    dialog.default.setText("")
    dialog.default.textEdited.emit("")
    dialog.list.setCurrentRow(1)
    dialog.remove.click()
    assert dialog.told.text().split("\n") == [
        "role becomes duty, with the value of 1 person.",
        "bag is removed: 1 person keeps it as an attribute of their own.",
        "duty: guest becomes visitor.",
    ]
    dialog.ok.click()
    assert _said(described) == {"bag": "yes", "duty": "visitor"}


def test_the_order_changes_and_a_wrong_number_is_told(described):
    dialog = _dialog(described)
    dialog.list.setCurrentRow(2)
    dialog.up.click()
    assert [one.name for one in dialog.draft.schema] == ["role", "age", "bag", "coat"]
    dialog.numbers["most"].setText("many")
    dialog.numbers["most"].textEdited.emit("many")
    assert (dialog.told.text(), dialog.ok.isEnabled()) == ("many is no number", False)
    dialog.reject()


def test_the_dialog_proposes_the_projects_schema_and_writes_one(hands, folder):
    write_schema(folder / "attributes.toml", SCHEMA)
    dialog = _dialog(hands)
    assert dialog.draft.schema == SCHEMA
    dialog.write(folder / "labels.json")
    assert read_schema(folder / "labels.json").schema[0] == ROLE
    dialog.read(folder / "recording.toml")
    assert "recording.toml" in dialog.told.text()
    dialog.reject()


@pytest.mark.parametrize("named", [False, True])
def test_a_session_drawn_in_a_project_begins_with_its_schema(window, qtbot, folder, named):
    if named:
        write_schema(folder.parent / "attributes.toml", SCHEMA)
    hands = Hands(window, open_for_correcting(window, qtbot, folder, 2), qtbot)
    hands.controller.editing.put_box((10.0, 10.0, 20.0, 40.0))
    hands.controller.editing.confirm()
    assert hands.controller.document.session.labels.schema == (SCHEMA if named else ())


def test_attributes_of_the_project_that_cannot_be_read_are_told(window, qtbot, folder):
    (folder / "attributes.toml").write_text("attributes = 3")
    open_for_correcting(window, qtbot, folder, 2)
    assert "attributes.toml" in window.notice.text


def test_it_is_told_where_the_project_says_other_attributes(hands, folder):
    document = hands.controller.document
    assert schema_notes(document) == ()
    write_schema(folder / "attributes.toml", SCHEMA)
    (line,) = schema_notes(document)
    assert "attributes.toml of the project says other attributes than this session" in line
    hands.controller.of(AttributeController).change(SchemaChange(SCHEMA))
    assert schema_notes(document) == ()
