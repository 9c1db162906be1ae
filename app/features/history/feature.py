"""The history of edits as a feature of the window."""

from __future__ import annotations

from typing import Final

from app.core.feature import Feature, Place
from app.features.history.controller import HistoryWalk
from app.features.history.panel import HistoryPanel

FEATURE: Final = Feature("history", HistoryWalk, HistoryPanel, Place.SIDE)
