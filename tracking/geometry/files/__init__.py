"""Calibration files: OpenCV, KITTI and ROS."""

from tracking.geometry.files.calibration_reader import calibration_text, read_calibration
from tracking.geometry.files.calibration_writer import write_calibration

__all__ = ["calibration_text", "read_calibration", "write_calibration"]
