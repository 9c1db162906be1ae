"""Foreground: the background learnt and subtracted, shadows removed."""

from tracking.foreground.background import BackgroundModel, Subtraction
from tracking.foreground.ramp import RampSettings, ramp, shaded
from tracking.foreground.settings import ForegroundSettings
from tracking.foreground.shade import ShadeColour
from tracking.foreground.shadow import PERHAPS, ShadowRemover

__all__ = [
    "PERHAPS",
    "BackgroundModel",
    "ForegroundSettings",
    "RampSettings",
    "ShadeColour",
    "ShadowRemover",
    "Subtraction",
    "ramp",
    "shaded",
]
