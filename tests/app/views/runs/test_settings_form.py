import pytest
from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QLabel

from app.views.runs.settings_form import FoldButton, SettingsForm
from tracking.trackers import TRACKERS, settings_fields


@pytest.fixture(params=list(TRACKERS))
def form(request, qtbot):
    form = SettingsForm(TRACKERS[request.param])
    qtbot.addWidget(form)
    form.spec = TRACKERS[request.param]
    return form


def _own_number(form):
    """The first number with a range among the tracker's own settings."""
    fields = settings_fields(form.spec.settings_type)
    return next(f for f in fields if f.type in (int, float) and f.range and "." not in f.name)


def test_a_form_left_alone_gives_the_defaults(form):
    assert form.values() == {}
    assert form.settings() == form.spec.settings_type()


def test_a_changed_value_is_the_only_one_that_differs(form, qtbot):
    field = _own_number(form)
    other = next(edge for edge in field.range if edge != field.default)
    with qtbot.waitSignal(form.edited):
        form.put(field.name, field.type(other))
    assert form.values() == {field.name: other}
    assert getattr(form.settings(), field.name) == other
    form.reset()
    assert form.values() == {}


def test_values_stay_within_their_range(form):
    field = _own_number(form)
    low, high = field.range
    form.put(field.name, field.type(high) + 1000)
    assert form.values() == {field.name: field.type(high)}
    form.put(field.name, field.type(low) - 1000)
    assert form.values() == {field.name: field.type(low)}


def test_every_control_has_a_name_and_a_description(form):
    for field in settings_fields(form.spec.settings_type):
        control = form._controls[field.name]
        assert control.accessibleName()
        assert control.toolTip().startswith(field.help)


def test_the_trackers_own_settings_stand_open_and_earlier_stages_are_folded(form):
    form.show()
    assert form._controls[_own_number(form).name].isVisible()
    folded = form._controls["foreground.threshold"]
    assert not folded.isVisible()
    names = [fold.text() for fold in form.findChildren(FoldButton)]
    stages = [f.name.partition(".") for f in settings_fields(form.spec.settings_type)]
    assert names == list(dict.fromkeys(stage.capitalize() for stage, dot, _ in stages if dot))
    assert "Foreground" in names
    next(f for f in form.findChildren(FoldButton) if f.text() == "Foreground").click()
    assert folded.isVisible()


def test_range_and_unit_are_written_beside_each_number(form):
    fields = settings_fields(form.spec.settings_type)
    field = next(f for f in fields if f.type is float and f.unit and f.range)
    said = [label.text() for label in form.findChildren(QLabel)]
    low, high = field.range
    assert any(f"({low:g} to {high:g} {field.unit})" in text for text in said)
    assert form._controls[field.name].suffix() == f" {field.unit}"


def test_settings_that_are_filled_in_elsewhere_have_no_control(qtbot):
    form = SettingsForm(TRACKERS["three-part"], without=("detector",))
    qtbot.addWidget(form)
    assert "detector" not in form._controls
    assert form.settings().detector == ""


def test_scrolling_over_a_number_that_is_not_being_edited_leaves_it_alone(form, wheel):
    form.show()
    control = form._controls[_own_number(form).name]
    wheel(control, QPointF(5, 5), 3)
    assert form.values() == {}
