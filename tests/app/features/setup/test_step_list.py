"""The list of the set-up's steps."""

from PySide6.QtWidgets import QApplication

from app.core.look.theme import Look, apply_look, contrast, current_theme
from app.features.setup.presenter import STEPS
from app.features.setup.scene import Mark
from app.features.setup.step_list import StepList


def test_marks_stand_out_after_the_theme_has_changed(qapp, qtbot):
    apply_look(qapp, Look.DARK)
    steps = StepList(None)
    qtbot.addWidget(steps)
    marks = (Mark.DONE, Mark.WARNING, Mark.OPEN)
    steps.show_marks([(marks[at % 3], "") for at in range(len(STEPS))])
    steps.show()
    for look in (Look.LIGHT, Look.DARK):
        apply_look(qapp, look)
        QApplication.processEvents()
        for row in range(len(marks)):
            drawn = steps.item(row).icon().pixmap(18, 18).toImage()
            inks = (drawn.pixelColor(x, y) for x in range(18) for y in range(18))
            solid = [ink for ink in inks if ink.alpha() > 250]
            assert max(contrast(ink, current_theme().surface) for ink in solid) >= 3
