"""Foreground: the background learnt and subtracted, shadows removed."""

from tracking.foreground.background import BackgroundModel, Subtraction
from tracking.foreground.settings import ForegroundSettings
from tracking.foreground.shade import ShadeColour
from tracking.foreground.shadow import PERHAPS, ShadowRemover

__all__ = [
    "PERHAPS",
    "BackgroundModel",
    "ForegroundSettings",
    "ShadeColour",
    "ShadowRemover",
    "Subtraction",
]
