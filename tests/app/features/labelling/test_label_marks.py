"""What people said of parts and what trackers say of them cannot be taken for each other."""

import numpy as np
import pytest
from PySide6.QtGui import QImage, QPainter

from app.core.drawing.label_marks import draw_parts
from app.core.drawing.viewport import Viewport
from app.core.scenes.labels import PartMark

SIDE = 200
BOX = (40.0, 40.0, 120.0, 120.0)


def drawn(given, on_part):
    """(side, side) how bright a mark is on black, 0 to 255."""
    image = QImage(SIDE, SIDE, QImage.Format.Format_RGB888)
    image.fill(0)
    painter = QPainter(image)
    mark = PartMark(1, 0, BOX, (255, 255, 255), given, on_part)
    draw_parts(painter, [mark], Viewport())
    painter.end()
    flat = np.frombuffer(image.constBits(), np.uint8).reshape(SIDE, -1)
    return flat[:, : 3 * SIDE].reshape(SIDE, SIDE, 3).max(axis=2).astype(int)


ANSWERS = [(True, True), (True, False), (True, None), (False, None)]


@pytest.mark.parametrize("answer", ANSWERS)
def test_no_answer_is_dashed_or_dotted_as_what_trackers_say(qtbot, answer):
    upper = drawn(*answer)[39:42, 50:150].max(axis=0)
    assert upper.min() == upper.max() > 60


def test_every_answer_looks_different_and_a_guess_is_the_faintest(qtbot):
    pictures = [drawn(*answer) for answer in ANSWERS]
    for number, one in enumerate(pictures):
        for other in pictures[:number]:
            assert (np.abs(one - other) > 60).sum() > 20
    assert pictures[-1].max() < min(one.max() for one in pictures[:-1])
