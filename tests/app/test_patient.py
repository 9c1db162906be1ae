"""The tests' own way of waiting is patient."""

from patient import PATIENCE_MS
from PySide6.QtCore import QTimer


def test_whoever_waits_is_patient_and_goes_on_at_once(qtbot):
    timer = QTimer(singleShot=True, interval=1)
    with qtbot.waitSignal(timer.timeout) as one, qtbot.waitSignals([timer.timeout]) as all_of_them:
        timer.start()
    assert one.timeout == all_of_them.timeout == PATIENCE_MS >= 60_000
