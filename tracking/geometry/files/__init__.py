"""Calibration files: OpenCV, KITTI and ROS."""

from tracking.geometry.files.reading import read_calibration
from tracking.geometry.files.writing import write_calibration

__all__ = ["read_calibration", "write_calibration"]
