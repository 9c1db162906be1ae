"""A track's card, and what a panel says."""

from __future__ import annotations

from PySide6.QtWidgets import QAbstractButton, QLabel

from app.core.scenes import TrackCard

CARD = TrackCard(4, "red coat", (200, 30, 30), 12, 402, 381, 9, 0.87, (("bag", "none"),), "turns")


def words(widget) -> str:
    labels = widget.findChildren(QLabel) + widget.findChildren(QAbstractButton)
    return " ".join(one.text() for one in labels if not one.isHidden())
