"""Stereo: range inside the foreground."""

from tracking.stereo.measured_depth import MeasuredDepth
from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines
from tracking.stereo.subtraction import STEP, SubtractionStereo, least_side_px
