"""What tests of pictures share."""

from __future__ import annotations

import pytest
from drawn_scenes import picture

from app.core.scenes import Side
from app.features.pictures.picture_view import PictureView


@pytest.fixture
def view(qtbot, dark) -> PictureView:
    """The left camera's picture, laid out."""
    widget = PictureView(Side.LEFT)
    qtbot.addWidget(widget)
    widget.resize(640, 480)
    widget.show_scene(picture())
    widget.grab()
    return widget
