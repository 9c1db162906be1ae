"""As much of a text as stands on a few lines."""

from __future__ import annotations

from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QFontMetrics

_HIGH_PX = 1_000_000
_ELLIPSIS = "\u2026"


def cut_to_lines(text: str, metrics: QFontMetrics, width: int, lines: int) -> str:
    """The text, or its first words and an ellipsis where all would take more lines."""
    room = QRect(0, 0, max(1, width - metrics.averageCharWidth()), _HIGH_PX)

    def fits(part: str) -> bool:
        taken = metrics.boundingRect(room, Qt.TextFlag.TextWordWrap, part)
        return taken.height() <= lines * metrics.lineSpacing()

    if fits(text):
        return text
    words = text.split(" ")
    low, high = 1, len(words)
    while low < high:
        middle = (low + high + 1) // 2
        if fits(" ".join(words[:middle]) + _ELLIPSIS):
            low = middle
        else:
            high = middle - 1
    return " ".join(words[:low]) + _ELLIPSIS
