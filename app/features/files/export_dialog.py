"""Which tracks are exported, and as what."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QFormLayout,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.widgets.dialog_ends import dialog_ends
from app.core.widgets.parts import quiet
from app.features.files.export_formats import ExportFormat

_LETTERS, _MOST_LINES = 62, 14


class ExportDialog(QDialog):
    """Lists the formats that are written.

    Signals:
        asked(str, int): a format by name, and whose tracks: -1 the corrected ones, else a run's.
    """

    asked = Signal(str, int)

    def __init__(
        self,
        formats: Sequence[ExportFormat],
        track_sources: Sequence[str],
        chosen: str,
        parent: QWidget,
    ) -> None:
        """track_sources: names, the corrected tracks first. chosen: the first format."""
        super().__init__(parent)
        self.setWindowTitle(tr("Export tracks"))
        self.setMinimumWidth(_LETTERS * self.fontMetrics().averageCharWidth())
        self._formats = tuple(formats)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(10)
        self._list = self._build_list(chosen)
        rows.addWidget(self._list, 1)
        self._about = quiet("", self)
        self._about.setWordWrap(True)
        rows.addWidget(self._about)
        self._track_sources = QComboBox(self)
        self._track_sources.addItems(list(track_sources))
        self._track_sources.setAccessibleName(tr("Whose tracks"))
        form = QFormLayout()
        form.addRow(tr("&Tracks"), self._track_sources)
        rows.addLayout(form)
        rows.addWidget(dialog_ends(self, tr("&Export...")))
        self._tell()
        self._list.setFocus()

    def _build_list(self, chosen: str) -> QListWidget:
        view = QListWidget(self)
        view.setAccessibleName(tr("Formats"))
        for each in self._formats:
            item = QListWidgetItem(each.title, view)
            item.setData(
                Qt.ItemDataRole.AccessibleTextRole,
                f"{each.title}, {each.ending or tr('folder')}",
            )
        names = [each.name for each in self._formats]
        view.setCurrentRow(names.index(chosen) if chosen in names else 0)
        view.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        view.setMinimumWidth(view.sizeHintForColumn(0) + 4 * view.frameWidth() + 24)
        rows = min(view.count(), _MOST_LINES)
        view.setMinimumHeight(rows * view.sizeHintForRow(0) + 2 * view.frameWidth() + 4)
        view.currentRowChanged.connect(self._tell)
        view.itemDoubleClicked.connect(self.accept)
        return view

    def _tell(self) -> None:
        self._about.setText(self._formats[self._list.currentRow()].about)

    def accept(self) -> None:
        """Go on to the place."""
        super().accept()
        self.asked.emit(
            self._formats[self._list.currentRow()].name, self._track_sources.currentIndex() - 1
        )
