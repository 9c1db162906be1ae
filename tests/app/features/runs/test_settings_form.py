import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from app.core.widgets.settings_form import SettingsForm
from app.core.widgets.settings_search import FoldButton
from app.features.runs.detections_line import FILLED_IN
from app.features.runs.track_dialog import TrackDialog
from tracking.recording import open_recording
from tracking.trackers import TRACKERS, best_tracker, settings_fields


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
    form.show_expert(True)
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


def test_a_changed_setting_is_marked_until_it_is_as_it_comes_again(form):
    field = _own_number(form)
    label = form._labels[field.name]
    plain = label.text()
    other = next(edge for edge in field.range if edge != field.default)
    form.put(field.name, field.type(other))
    assert label.text() != plain
    assert label.font().bold()
    assert str(field.default) in label.toolTip()
    form.reset()
    assert (label.text(), label.font().bold()) == (plain, False)


@pytest.mark.parametrize(("typed", "taken"), [("0", 0), ("999999999", 1)])
def test_a_number_out_of_range_is_told_and_the_nearest_is_taken(qtbot, typed, taken):
    form = SettingsForm(TRACKERS["stereo-colour"])
    qtbot.addWidget(form)
    fields = settings_fields(TRACKERS["stereo-colour"].settings_type)
    field = next(one for one in fields if one.name == "particles")
    control = form._controls["particles"]
    form.show()
    control.selectAll()
    QTest.keyClicks(control, typed)
    told = [label.text() for label in form.findChildren(QLabel) if "out of range" in label.text()]
    assert len(told) == 1
    assert typed in told[0]
    QTest.keyClick(control, Qt.Key.Key_Return)
    assert control.value() == field.range[taken]
    assert not any("out of range" in label.text() for label in form.findChildren(QLabel))


def test_defaults_take_back_what_was_typed_out_of_range(qtbot):
    form = SettingsForm(TRACKERS["stereo-colour"])
    qtbot.addWidget(form)
    control = form._controls["particles"]
    form.show()
    control.selectAll()
    QTest.keyClicks(control, "999999999")
    form.reset()
    assert not any("out of range" in label.text() for label in form.findChildren(QLabel))
    QTest.keyClick(control, Qt.Key.Key_Return)
    assert form.values() == {}


def test_a_switch_that_is_changed_says_on_or_off_as_it_comes(qtbot):
    form = SettingsForm(TRACKERS["stereo-colour"])
    qtbot.addWidget(form)
    form.put("paper", True)
    assert form._labels["paper"].toolTip().endswith("off")


def test_settings_of_a_tracker_stand_under_headings(qtbot):
    form = SettingsForm(TRACKERS["stereo-joint"])
    qtbot.addWidget(form)
    said = [label.text() for label in form.findChildren(QLabel)]
    assert {"Particles and motion", "Association", "Track management"} <= set(said)


def test_a_tracker_that_does_not_suit_the_recording_is_listed_with_the_reason(
    qtbot, tiny_recording, remembered
):
    left = tiny_recording / "left.mp4"
    with open_recording(
        left if left.exists() else next(tiny_recording.glob("left*"))
    ) as one_camera:
        dialog = TrackDialog(one_camera, best_tracker(one_camera), remembered)
        qtbot.addWidget(dialog)
        row = dialog._names.index("stereo-joint")
        assert not dialog._choice.model().item(row).isEnabled()
        assert "needs two" in dialog._choice.itemData(row, Qt.ItemDataRole.ToolTipRole)
        assert dialog.answer()[0] == best_tracker(one_camera)
        assert "best for this recording" in dialog._title.text()


@pytest.fixture
def dialog(qtbot, tiny_recording, remembered):
    with open_recording(tiny_recording) as recording:
        dialog = TrackDialog(recording, "stereo-joint", remembered)
        qtbot.addWidget(dialog)
        dialog.show()
        yield dialog


def _in_sight(dialog):
    return {name for name, one in dialog.form._controls.items() if one.isVisible()}


def test_settings_are_found_by_words_of_name_and_help(dialog):
    before = _in_sight(dialog)
    dialog._search.setText("person parti")
    found = _in_sight(dialog)
    assert "particles" in found
    assert len(found) < 5
    dialog._search.clear()
    assert _in_sight(dialog) == before


def test_a_setting_is_found_by_the_name_it_had_in_earlier_versions(dialog):
    dialog._search.setText("agility")
    assert _in_sight(dialog) == {"process_noise"}


def test_a_setting_of_an_earlier_stage_is_found_though_its_group_is_folded(dialog):
    assert "foreground.threshold" not in _in_sight(dialog)
    dialog._search.setText("foreground threshold")
    assert "foreground.threshold" in _in_sight(dialog)
    folds = {one.text() for one in dialog.form.findChildren(FoldButton) if one.isVisible()}
    assert "Stereo" not in folds
    dialog._search.clear()
    assert "foreground.threshold" not in _in_sight(dialog)


def test_words_that_no_setting_has_are_told(dialog):
    dialog._search.setText("xylophone")
    assert _in_sight(dialog) == set()
    assert dialog._nothing.isVisible()


def test_what_is_sought_is_sought_in_another_trackers_settings_too(dialog):
    dialog._search.setText("particles")
    dialog._choice.setCurrentIndex(dialog._names.index("stereo-colour"))
    assert "particles" in _in_sight(dialog)
    assert "foreground.threshold" not in _in_sight(dialog)


def test_enter_in_the_search_does_not_begin_tracking(dialog, heard):
    began = heard(dialog.accepted)
    dialog._search.setFocus()
    QTest.keyClicks(dialog._search, "particles")
    QTest.keyClick(dialog._search, Qt.Key.Key_Return)
    assert began == []
    assert dialog.isVisible()


@pytest.mark.parametrize(
    ("field", "typed", "taken"),
    [("_first", "2.5", 2), ("_last", "5000", None), ("_seed", "2,5", 2)],
)
def test_a_frame_or_seed_that_cannot_be_is_told_and_the_nearest_is_taken(
    dialog, field, typed, taken
):
    box = getattr(dialog, field)
    box.selectAll()
    QTest.keyClicks(box, typed)
    assert dialog._refused.isVisible()
    assert dialog._refused.text().startswith(f"{typed} is out of range: whole numbers from 0 to ")
    box.interpretText()  # as Qt does once it is left
    assert box.value() == (box.maximum() if taken is None else taken)


def _names(tracker, *, expert):
    """Of settings outside of folded groups."""
    fields = settings_fields(TRACKERS[tracker].settings_type)
    return {field.name for field in fields if field.expert == expert and "." not in field.name}


def test_expert_settings_are_shown_on_request(dialog):
    plain, expert = (_names("stereo-joint", expert=asked) for asked in (False, True))
    assert expert
    assert _in_sight(dialog) == plain
    dialog._expert.click()
    assert _in_sight(dialog) == plain | expert
    dialog._expert.click()
    assert _in_sight(dialog) == plain


def test_the_check_box_says_how_many_expert_settings_the_chosen_tracker_has(dialog):
    fields = settings_fields(TRACKERS["stereo-joint"].settings_type)
    count = sum(field.expert and field.name not in FILLED_IN for field in fields)
    all_ = sum(field.expert for field in fields)  # as on the command line
    assert f"({count} of {all_})" in dialog._expert.text()
    before = dialog._expert.text()
    dialog._choice.setCurrentIndex(dialog._names.index("flow"))
    assert dialog._expert.text() != before


def test_whether_expert_settings_are_shown_is_remembered(dialog, qtbot, remembered, tiny_recording):
    dialog._expert.click()
    with open_recording(tiny_recording) as recording:
        later = TrackDialog(recording, "stereo-joint", remembered)
        qtbot.addWidget(later)
        later.show()
        assert _in_sight(later) >= _names("stereo-joint", expert=True)
        later._expert.click()
        last = TrackDialog(recording, "stereo-joint", remembered)
        qtbot.addWidget(last)
        last.show()
        assert not _in_sight(last) & _names("stereo-joint", expert=True)


def test_expert_settings_are_shown_for_every_tracker_that_is_chosen(dialog):
    dialog._expert.click()
    dialog._choice.setCurrentIndex(dialog._names.index("flow"))
    assert "confirm_timeout_s" in _in_sight(dialog)


@pytest.mark.parametrize(("name", "value"), [("miss_probability", 0.2), ("people.hue_bins", 20)])
def test_an_expert_setting_that_is_changed_is_always_shown(dialog, name, value):
    assert name not in _in_sight(dialog)
    dialog.put_settings("stereo-joint", {name: value}, 0)
    assert name in _in_sight(dialog)
    for _ in range(2):
        dialog._expert.click()
    assert name in _in_sight(dialog)
    dialog.form.put(name, dict(_defaults("stereo-joint"))[name])
    assert name in _in_sight(dialog), "it stays while it is worked on"
    dialog.form.reset()
    assert name not in _in_sight(dialog)


def _defaults(tracker):
    for field in settings_fields(TRACKERS[tracker].settings_type):
        yield field.name, field.default


def test_search_finds_expert_settings_and_hides_them_again(dialog):
    dialog._search.setText("miss probability")
    assert _in_sight(dialog) == {"miss_probability"}
    dialog._search.clear()
    assert "miss_probability" not in _in_sight(dialog)


def test_a_group_without_a_setting_to_show_has_no_heading(dialog):
    dialog._choice.setCurrentIndex(dialog._names.index("spheroid"))
    ramp = next(one for one in dialog.form.findChildren(FoldButton) if one.text() == "Ramp")
    assert not ramp.isVisible()
    dialog._expert.click()
    assert ramp.isVisible()
