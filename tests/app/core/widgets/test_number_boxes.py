"""Number fields take what people type, and never another number unsaid."""

import pytest
from PySide6.QtCore import QLocale, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDoubleSpinBox, QSpinBox, QToolTip

from app.core.widgets.number_boxes import NumberBox, WholeBox, tell_beside
from app.features.files.import_dialog import ImportDialog

C, GERMAN = QLocale.c(), QLocale(QLocale.Language.German)


@pytest.fixture
def field(qtbot):
    """Makes a field of a kind with a range and a unit, all its text selected."""

    def made(kind, low, high, locale=C):
        box = kind()
        qtbot.addWidget(box)
        box.setLocale(locale)
        box.setRange(low, high)
        box.setSuffix(" s")
        box.setValue(low)
        box.show()
        box.selectAll()
        return box

    return made


@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
@pytest.mark.parametrize("typed", ["5abc", "7x", "5 000x"])
def test_what_is_no_number_cannot_be_typed_into_its_field(field, kind, typed):
    box = field(kind, 0, 99)
    QTest.keyClicks(box, typed)
    assert box.cleanText().isdigit()
    shown = float(box.cleanText())
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == min(shown, 99)


@pytest.mark.parametrize("locale", [C, GERMAN])
@pytest.mark.parametrize("typed", ["2,5", "2.5"])
def test_decimals_stand_behind_a_comma_or_a_point(field, typed, locale):
    box = field(NumberBox, 0, 99, locale)
    QTest.keyClicks(box, typed)
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 2.5


@pytest.mark.parametrize("typed", ["2,7", "2.7"])
def test_of_decimals_in_a_whole_number_the_nearest_is_told_and_taken(field, heard, typed):
    box = field(WholeBox, 0, 99)
    told = heard(box.typed)
    QTest.keyClicks(box, typed)
    assert told[-1] == typed
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert (box.value(), told[-1]) == (3, "")


def _paste(box, text):
    QApplication.clipboard().setText(text)
    box.lineEdit().paste()


@pytest.mark.parametrize("put", [QTest.keyClicks, _paste])
@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
@pytest.mark.parametrize(
    ("locale", "typed", "taken"),
    [
        (C, "1,800", 1800),
        (C, "25,000", 25000),
        (QLocale(QLocale.Language.English), "1,250,000", 1250000),
        (GERMAN, "25.000", 25000),
        (GERMAN, "1.800", 1800),
    ],
)
def test_thousands_may_be_told_by_their_sign(field, heard, put, kind, locale, typed, taken):
    box = field(kind, 10, 2000000, locale)
    told = heard(box.typed)
    put(box, typed)
    assert told[-1] == ""
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert (box.value(), told[-1]) == (taken, "")


@pytest.mark.parametrize("put", [QTest.keyClicks, _paste])
@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
@pytest.mark.parametrize(("locale", "typed"), [(C, "25,000"), (GERMAN, "25.000")])
def test_thousands_out_of_range_are_told_and_the_nearest_is_taken(
    field, heard, put, kind, locale, typed
):
    box = field(kind, 10, 20000, locale)
    told = heard(box.typed)
    put(box, typed)
    assert told[-1] == typed
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 20000


@pytest.mark.parametrize("put", [QTest.keyClicks, _paste])
@pytest.mark.parametrize(
    ("locale", "typed", "taken"),
    [(C, "0,125", 0.125), (C, "2,75", 2.75), (GERMAN, "0.125", 0.125), (GERMAN, "2,125", 2.125)],
)
def test_decimals_are_never_read_as_thousands(field, put, locale, typed, taken):
    box = field(NumberBox, 0, 36000, locale)
    box.setDecimals(3)
    box.selectAll()
    put(box, typed)
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == taken


def test_decimals_in_a_whole_number_are_never_read_as_thousands(field, heard):
    box = field(WholeBox, 0, 36000)
    told = heard(box.typed)
    QTest.keyClicks(box, "2,7")
    assert told[-1] == "2,7"
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 3


@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
def test_thousands_left_half_typed_are_the_number_before(field, kind):
    box = field(kind, 10, 2000000)
    QTest.keyClicks(box, "1,800,0")
    assert box.cleanText() == "1,800,0"
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 1800


@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
@pytest.mark.parametrize("pasted", ["1,25,000", "1,8000,000", "1,,000"])
def test_what_is_grouped_as_no_number_cannot_be_pasted(field, kind, pasted):
    box = field(kind, 10, 2000000)
    before = box.text()
    _paste(box, pasted)
    assert box.text() == before


@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
def test_a_sign_that_groups_no_number_cannot_be_typed(field, heard, kind):
    box = field(kind, 10, 2000000)
    told = heard(box.typed)
    QTest.keyClicks(box, "1,25,")
    assert (box.cleanText(), told[-1]) == ("1,25", "1,25")


def test_thousands_are_grouped_as_where_the_user_is(field):
    box = field(WholeBox, 10, 2000000, QLocale("en_IN"))
    QTest.keyClicks(box, "1,25,000")
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 125000


@pytest.mark.parametrize("kind", [WholeBox, NumberBox])
@pytest.mark.parametrize("pasted", ["inf", "-inf", "nan", "NaN", "1e400", "infinity"])
def test_what_is_not_finite_cannot_be_pasted(field, kind, pasted):
    box = field(kind, 10, 20000)
    before = box.text()
    _paste(box, pasted)
    assert box.text() == before
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert box.value() == 10


def test_a_field_without_a_line_for_it_says_under_itself_what_it_refuses(field, qtbot):
    box = field(WholeBox, 0, 99)
    tell_beside(box)
    QTest.keyClicks(box, "120")
    assert (
        QToolTip.text()
        == "120 is out of range: whole numbers from 0 to 99 s. The nearest value is used."
    )
    QTest.keyClick(box, Qt.Key.Key_Backspace)
    qtbot.waitUntil(lambda: not QToolTip.isVisible())
    assert box.value() == 12
    QToolTip.showText(QPoint(), "of a button", box)
    box.setValue(13)
    qtbot.wait(500)  # tips vanish after a while, not at once
    assert QToolTip.text() == "of a button"


def test_every_number_field_of_the_window_tells_what_it_refuses(window):
    dialog = ImportDialog("tracks.csv", [], window)
    fields = window.findChildren(QSpinBox) + window.findChildren(QDoubleSpinBox)
    assert len(fields) >= 7
    for number, field in enumerate(fields, start=1):
        assert isinstance(field, WholeBox | NumberBox)
        field.typed.emit(f"{number}e9")  # one of its own: tips vanish after a while, not at once
        assert QToolTip.text().startswith(f"{number}e9 is out of range")
    dialog.deleteLater()
