"""Calibration files: OpenCV, KITTI and ROS."""

from tracking.geometry.files.reading import calibration_text, read_calibration
from tracking.geometry.files.writing import write_calibration

__all__ = ["calibration_text", "read_calibration", "write_calibration"]
