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


def test_a_form_left_alone_gives_the_defaults(form):
    assert form.values() == {}
    assert form.settings() == form.spec.settings_type()


def test_a_changed_value_is_the_only_one_that_differs(form, qtbot):
    with qtbot.waitSignal(form.edited):
        form.put("particles", 321)
    assert form.values() == {"particles": 321}
    assert form.settings().particles == 321
    form.reset()
    assert form.values() == {}


def test_values_stay_within_their_range(form):
    low, high = {f.name: f for f in settings_fields(form.spec.settings_type)}["particles"].range
    form.put("particles", int(high) + 1000)
    assert form.values() == {"particles": int(high)}
    form.put("particles", int(low) - 1000)
    assert form.values() == {"particles": int(low)}


def test_every_control_has_a_name_and_a_description(form):
    for field in settings_fields(form.spec.settings_type):
        control = form._controls[field.name]
        assert control.accessibleName()
        assert control.toolTip().startswith(field.help)


def test_the_trackers_own_settings_stand_open_and_earlier_stages_are_folded(form):
    form.show()
    assert form._controls["particles"].isVisible()
    folded = form._controls["foreground.threshold"]
    assert not folded.isVisible()
    names = [fold.text() for fold in form.findChildren(FoldButton)]
    assert names == ["Foreground", "Stereo", "People"]
    form.findChildren(FoldButton)[0].click()
    assert folded.isVisible()


def test_range_and_unit_are_written_beside_each_number(form):
    said = [label.text() for label in form.findChildren(QLabel)]
    assert any("(0.1 to 5 m)" in text for text in said)
    assert form._controls["gate_m"].suffix() == " m"


def test_scrolling_over_a_number_that_is_not_being_edited_leaves_it_alone(form, wheel):
    form.show()
    control = form._controls["particles"]
    wheel(control, QPointF(5, 5), 3)
    assert form.values() == {}
