"""How far annotators agree, over all recordings of a project, as a table with totals."""

from __future__ import annotations

import math
from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QLabel,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import N_, count_text, sentence, tr
from app.core.widgets.parts import heading, quiet
from tracking.project.agreements import PairAgreement, pooled

_TITLES = (
    *(N_("Recording"), N_("Annotator"), N_("Other annotator"), N_("IDF1"), N_("Kappa")),
    *(N_("Person-frames"), N_("Disagreements")),
)
_WORDS = 3
"""Columns that hold words, the first ones."""
_WIDTH_LETTERS, _HEIGHT_LINES = 160, 26
_NAME_LETTERS = 24
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class AgreementDialog(QDialog):
    """Lists pairs of sessions; the least agreement first."""

    def __init__(self, pairs: Sequence[PairAgreement], parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Agreement between annotators"))
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        self.total = heading(_total_text(pairs), self)
        self.total.setWordWrap(True)
        rows.addWidget(self.total)
        rows.addWidget(self._about())
        self.table = self._build_table(sorted(pairs, key=_order))
        rows.addWidget(self.table, 1)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        buttons.rejected.connect(self.reject)
        rows.addWidget(buttons)
        letters = self.fontMetrics()
        room = parent.size()
        self.resize(
            min(_WIDTH_LETTERS * letters.averageCharWidth(), room.width()),
            min(_HEIGHT_LINES * letters.lineSpacing(), room.height()),
        )
        self.table.setFocus()

    def _about(self) -> QLabel:
        label = quiet(
            tr(
                "Neither side counts as the truth. Kappa is 1 where both say the same of everybody "
                "in every frame, and 0 where they agree no more than by chance. Where both look "
                "right, open one session and compare it with the other (File)."
            ),
            self,
        )
        label.setWordWrap(True)
        return label

    def _build_table(self, pairs: Sequence[PairAgreement]) -> QTableWidget:
        table = QTableWidget(len(pairs), len(_TITLES), self)
        for column, title in enumerate(_TITLES):
            head = QTableWidgetItem(tr(title))
            head.setTextAlignment(_RIGHT if column >= _WORDS else _LEFT)
            table.setHorizontalHeaderItem(column, head)
        table.setAccessibleName(tr("Agreement between annotators"))
        table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        table.setShowGrid(False)
        table.setTabKeyNavigation(False)
        table.verticalHeader().hide()
        header = table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        table.setWordWrap(False)
        table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        name_px = _NAME_LETTERS * self.fontMetrics().averageCharWidth()
        table.setMinimumWidth(name_px + sum(map(header.sectionSizeHint, range(1, len(_TITLES)))))
        header.setHighlightSections(False)
        for number, pair in enumerate(pairs):
            for column, text in enumerate(_cells(pair)):
                item = QTableWidgetItem(text)
                item.setToolTip(text)
                if column >= _WORDS:
                    item.setTextAlignment(_RIGHT)
                if pair.problem:
                    item.setToolTip(sentence(pair.problem))
                table.setItem(number, column, item)
        return table


def _order(pair: PairAgreement) -> tuple[bool, float, str]:
    """What cannot be compared comes first, then the least agreement."""
    kappa = math.inf if math.isnan(pair.kappa) else pair.kappa
    return not pair.problem, kappa, pair.recording


def _cells(pair: PairAgreement) -> tuple[str, ...]:
    words = (pair.recording, pair.a, pair.b)
    if pair.problem:
        return (*words, tr("cannot be compared"), "", "", "")
    figures = (_figure(pair.idf1), _figure(pair.kappa), str(pair.rows), str(pair.disagreements))
    return (*words, *figures)


def _total_text(pairs: Sequence[PairAgreement]) -> str:
    whole = pooled(pairs)
    recordings = len({pair.recording for pair in pairs})
    words = [
        tr("IDF1 {figure}", figure=_figure(whole.idf1)),
        tr("kappa {figure}", figure=_figure(whole.kappa)),
        count_text(recordings, "{n} recording", "{n} recordings"),
        count_text(whole.rows, "{n} person-frame", "{n} person-frames"),
        count_text(whole.disagreements, "{n} disagreement", "{n} disagreements"),
    ]
    return "  \u00b7  ".join(words)


def _figure(value: float) -> str:
    return "\u2013" if math.isnan(value) else f"{value:.3f}"
