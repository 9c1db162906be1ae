"""Foreground: the background learnt and subtracted, shadows removed, the camera watched."""

from tracking.foreground.background import BackgroundModel, Subtraction
from tracking.foreground.background_modes import SecondaryMode
from tracking.foreground.body_masks import BodyMasks, learn_frame
from tracking.foreground.camera_watch import CameraWatch
from tracking.foreground.light_and_chroma import in_size
from tracking.foreground.marks import Marks
from tracking.foreground.ramp import RampSettings, ramp
from tracking.foreground.settings import ForegroundSettings
from tracking.foreground.shade import ShadeColour
from tracking.foreground.shadow import PERHAPS, ShadowRemover
from tracking.foreground.shadow_weights import ShadowWeights
