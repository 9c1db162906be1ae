"""Cameras, the floor and calibration files."""

from tracking.geometry.calibration_reader import calibration_text, read_calibration, says_rough
from tracking.geometry.calibration_writer import write_calibration
from tracking.geometry.camera import Camera
from tracking.geometry.flat_view import FlatView
from tracking.geometry.ground import Ground, ground_of_plane, ground_of_pose
from tracking.geometry.quadrics import Ellipses, ellipses_of, standing_ellipses
from tracking.geometry.rectification import Rectification
from tracking.geometry.stereo_calibration import StereoCalibration, depth_pair
from tracking.geometry.view import View
