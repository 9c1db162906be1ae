import pytest
from PySide6.QtGui import QImage

from app.shell.application import picture
from tracking.errors import OutputError, TrackwrightError


@pytest.mark.parametrize(("theme", "dark"), [("dark", True), ("light", False)])
def test_the_real_window_is_drawn_into_a_picture(
    qapp, no_threads_left, tiny_session, tmp_path, theme, dark
):
    out = picture(tiny_session, tmp_path / "window.png", theme=theme, size=(1000, 700))
    image = QImage(str(out))
    assert (image.width(), image.height()) == (1000, 700)
    corner = image.pixelColor(400, 5)
    assert (corner.lightness() < 128) is dark


def test_a_picture_of_what_cannot_be_opened_is_an_error(qapp, no_threads_left, tmp_path):
    with pytest.raises(TrackwrightError):
        picture(tmp_path / "nothing.h5", tmp_path / "window.png")


def test_a_picture_that_cannot_be_written_is_an_error(
    qapp, no_threads_left, tiny_session, tmp_path
):
    with pytest.raises(OutputError, match="cannot write"):
        picture(tiny_session, tmp_path / "no" / "folder" / "window.png")
