"""A window is no larger than the screen it opens on."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QMargins, QRect, QSize
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QAbstractButton

from app.core import i18n
from app.features.welcome.welcome_parts import RecentRow
from app.shell.main_window import MainWindow
from app.shell.screen_fit import fitted, keep_on_screen

FRAME = QMargins(4, 24, 4, 4)
_SIDES = st.integers(200, 4000)


@given(_SIDES, _SIDES, st.integers(-2000, 2000), _SIDES, _SIDES)
def test_the_window_and_its_frame_lie_inside_the_room(width, height, left, wide, high):
    room = QRect(left, 30, width, height)
    place = fitted(room, QSize(wide, high), FRAME)
    assert room.contains(place.marginsAdded(FRAME))


def test_a_window_that_fits_has_the_size_it_wants():
    place = fitted(QRect(0, 0, 1920, 1080), QSize(1440, 900), FRAME)
    assert place.size() == QSize(1440, 900)


@pytest.fixture
def fresh(qtbot, remembered):
    window = MainWindow(remembered)
    yield window
    window.close()
    window.deleteLater()


def test_a_first_start_on_a_small_screen_opens_inside_it(fresh):
    room = QGuiApplication.primaryScreen().availableGeometry()
    assert room.width() < 1440
    assert room.contains(fresh.geometry())


@pytest.mark.parametrize("language", ["en", "ja"])
def test_a_start_after_many_recordings_fits_the_smallest_screen(
    remembered, qtbot, language, tmp_path
):
    for number in range(20):
        remembered.add_recent(tmp_path / f"session {number}.h5", "a recording")
    i18n.use_language(language)
    window = MainWindow(remembered)
    window.show()
    qtbot.waitUntil(lambda: len(window.findChildren(RecentRow)) > 5)
    assert window.minimumSizeHint().height() <= 640
    window.close()
    window.deleteLater()
    i18n.use_language("en")


def test_one_that_was_made_larger_than_the_screen_comes_back_inside_it(fresh):
    room = QGuiApplication.primaryScreen().availableGeometry()
    fresh.setGeometry(100, 100, 1600, 1000)
    keep_on_screen(fresh)
    assert room.contains(fresh.geometry())


def test_the_panels_at_the_right_are_not_cut_in_a_small_window_once_there_are_tracks(
    window, controller, qtbot
):
    window.resize(1000, 640)
    window.show()
    column = window.workspace._panels
    controller.editing.pick(controller.document.tracks.ids[0])
    window.workspace.card.setMinimumWidth(column.width() + 40)  # as larger letters would

    def ends() -> list[int]:
        """Of the buttons that are seen, px in the part of the column that is."""
        seen = [one for one in column.widget().findChildren(QAbstractButton) if one.isVisible()]
        return [one.mapTo(column.viewport(), one.rect().topRight()).x() for one in seen]

    qtbot.waitUntil(lambda: max(ends()) <= column.viewport().width())
    assert column.widget().width() <= column.viewport().width()
