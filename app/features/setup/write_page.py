"""The last step: what will be written."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QLineEdit, QPlainTextEdit, QWidget

from app.core.i18n import tr
from app.features.setup import write_presenter
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.controller import SetupEditor
from app.features.setup.floor_presenter import floor_picture
from app.features.setup.presenter import may_write
from app.features.setup.region_presenter import kept_told
from app.features.setup.scene import SetupPicture, SetupScene, Step
from app.features.setup.step_page import StepPage, plain

_LINES = 12


class WritePage(StepPage):
    """recording.toml as it will be, its name, and what is still open.

    Signals: write_asked().
    """

    step = Step.WRITE
    write_asked = Signal()

    def __init__(self, editor: SetupEditor, parent: QWidget) -> None:
        said = tr("This will be written beside the cameras' files; paths are relative.")
        super().__init__(editor, tr("Write"), said, parent)
        form = self.form()
        self.name = QLineEdit(self.widget())
        self.name.setAccessibleName(tr("Name of the recording"))
        self.name.editingFinished.connect(self._type)
        form.addRow(tr("Name"), self.name)
        self.rows.addLayout(form)
        self.remarks = plain("", self, "warning")
        self.rows.addWidget(self.problem)
        self.rows.addWidget(self.remarks)
        self.text = QPlainTextEdit(self.widget())
        self.text.setReadOnly(True)
        self.text.setTabChangesFocus(True)
        self.text.setAccessibleName(tr("recording.toml that will be written"))
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.text.setLineWrapMode(QPlainTextEdit.LineWrapMode.WidgetWidth)
        self.text.setMinimumHeight(_LINES * self.text.fontMetrics().lineSpacing())
        self.rows.addWidget(self.text, 1)
        self.places = plain("", self)
        self.rows.addWidget(self.places)
        self.write = self.button(tr("Write and open"), self.write_asked.emit)
        self.write.setProperty("primary", True)
        self.rows.addWidget(self.write)

    def fill(self, scene: SetupScene) -> None:
        """The text."""
        plan = scene.state.plan
        if plan is not None and not self.name.hasFocus():
            self.name.setText(plan.name)
            named = tr("{name} (as the folder)", name=write_presenter.default_name(plan))
            self.name.setPlaceholderText(named)
        if not self.isVisible():
            return
        text = scene.checked.text if plan is not None else tr("# Choose the cameras first.")
        if text != self.text.toPlainText():
            self.text.setPlainText(text)
        remarks = write_presenter.remarks(scene)
        self.remarks.setText("\n".join(remarks))
        self.remarks.setVisible(bool(remarks))
        places = scene.checked.places if plan is not None else ""
        self.places.setText("\n".join(filter(None, (places, kept_told(scene.state)))))
        self.write.setEnabled(may_write(scene))

    def picture(self, scene: SetupScene) -> SetupPicture:
        """The left image with the floor, the whole of what was found."""
        plan = scene.state.plan
        if plan is None or plan.ground is None:
            return cameras_picture(scene)
        return floor_picture(scene, self.pointer, with_points=False)

    def _type(self) -> None:
        state, name = self.editor.state, self.name.text().strip()
        if state.plan is not None and name != state.plan.name:
            self.editor.change(replace(state, plan=replace(state.plan, name=name)))
