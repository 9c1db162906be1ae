"""Foreground: the background learnt and subtracted, shadows removed."""

from tracking.foreground.background import BackgroundModel, Subtraction
from tracking.foreground.settings import ForegroundSettings
from tracking.foreground.shadow import ShadowRemover

__all__ = ["BackgroundModel", "ForegroundSettings", "ShadowRemover", "Subtraction"]
