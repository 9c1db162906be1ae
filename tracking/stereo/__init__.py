"""Stereo: range inside the foreground."""

from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines
from tracking.stereo.subtraction import SubtractionStereo

__all__ = ["SightLines", "StereoSettings", "SubtractionStereo"]
