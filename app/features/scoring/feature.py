"""Scoring as a feature of the window."""

from __future__ import annotations

from typing import Final

from app.core.feature import Feature
from app.features.scoring.commands import VIEWS
from app.features.scoring.controller import ScoreController
from app.features.scoring.panel import ScorePanel

FEATURE: Final = Feature("score", ScoreController, ScorePanel, commands=VIEWS)
