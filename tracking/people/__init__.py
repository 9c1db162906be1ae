"""Regions of the foreground as people."""

from tracking.people.depth_perception import DepthPerception
from tracking.people.detections import Detections
from tracking.people.first_lag import first_lag, lag_looks
from tracking.people.observation import Observation, Overlays
from tracking.people.perception import StereoPerception
from tracking.people.range_check import RangedShare
from tracking.people.settings import PeopleSettings
from tracking.people.single_camera import SingleCameraPerception
from tracking.people.stereo_watch import StereoWatch
