"""The base of everything that turns gestures of one subject into changes, and shows them."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal


class Controller(QObject):
    """A controller of one subject.

    What a controller says and what fails is passed on to the controller it belongs to, and so
    reaches the window, which alone shows messages.

    Signals:
        changed(): what is shown, or what can be done, is another.
        said(str): a passing word for the user.
        failed(object): an exception the user is told of.
    """

    changed = Signal()
    said = Signal(str)
    failed = Signal(object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        if isinstance(parent, Controller):
            self.said.connect(parent.said)
            self.failed.connect(parent.failed)
