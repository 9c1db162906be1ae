"""Where the floor is, seen from the left camera: by stereo, points, a board, a pose or people."""

from tracking.calibration.floor.board import floor_by_board, floor_of_board
from tracking.calibration.floor.estimate import FloorEstimate, with_calibration
from tracking.calibration.floor.people import floor_by_people
from tracking.calibration.floor.points import FloorPoint, floor_by_distances, floor_by_points
from tracking.calibration.floor.pose import floor_by_pose
from tracking.calibration.floor.stereo import floor_by_stereo

__all__ = [
    "FloorEstimate",
    "FloorPoint",
    "floor_by_board",
    "floor_by_distances",
    "floor_by_people",
    "floor_by_points",
    "floor_by_pose",
    "floor_by_stereo",
    "floor_of_board",
    "with_calibration",
]
