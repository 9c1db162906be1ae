"""Body parts as a feature of the window."""

from __future__ import annotations

from typing import Final

from app.core.feature import Feature
from app.features.parts.commands import VIEWS
from app.features.parts.controller import PartsController
from app.features.parts.panel import CurvesPanel

FEATURE: Final = Feature("curves", PartsController, CurvesPanel, commands=VIEWS)
