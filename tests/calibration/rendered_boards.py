"""Images of boards as known cameras see them."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.calibration.boards import Board
from tracking.geometry import Camera, Ground, StereoCalibration

SIZE = (640, 480)
PX_PER_UNIT = 60
"""Of the print, for each square."""
_MARGIN = 1
"""White squares around the print."""

CAMERA = Camera(
    np.array([[520.0, 0, 322.0], [0, 518.0, 236.0], [0, 0, 1]]),
    np.array([-0.12, 0.05, 0.001, -0.0005, 0.0]),
    *SIZE,
)
GROUND = Ground(1.6, 35.0, 4.0)
"""Below the cameras that see a board lie on the floor."""
FISHEYE = Camera(
    np.array([[330.0, 0, 318.0], [0, 331.0, 241.0], [0, 0, 1]]),
    np.array([0.02, -0.005, 0.001, 0.0]),
    *SIZE,
    fisheye=True,
)


def pair_of(camera: Camera, baseline_m: float = 0.12) -> StereoCalibration:
    """Two such cameras, the right one turned a little."""
    rotation, _ = cv2.Rodrigues(np.array([0.01, -0.02, 0.005]))
    return StereoCalibration(camera, camera, rotation, np.array([-baseline_m, 0.002, 0.001]))


def print_of(board: Board) -> tuple[NDArray[np.uint8], float, float]:
    """The print (grey), and where its first point lies in it: px right and down."""
    unit = PX_PER_UNIT
    if board.kind == "charuco":
        size = board.columns * unit, board.rows * unit
        drawn = board.charuco(board.dictionary).generateImage(size)
        paper = cv2.copyMakeBorder(drawn, unit, unit, unit, unit, cv2.BORDER_CONSTANT, value=255)
        return paper, 2.0 * unit, 2.0 * unit
    if board.kind == "chessboard":
        row, column = np.indices((board.rows + 1, board.columns + 1))
        squares = np.where((row + column) % 2 == 0, 0, 255).astype(np.uint8)
        drawn = np.kron(squares, np.ones((unit, unit), np.uint8))
        paper = cv2.copyMakeBorder(drawn, unit, unit, unit, unit, cv2.BORDER_CONSTANT, value=255)
        return paper, 2.0 * unit, 2.0 * unit
    places = board.places()[:, :2] / board.unit_m
    width, height = places.max(axis=0) + 2 * (1 + _MARGIN)
    paper = np.full((int(height * unit), int(width * unit)), 255, np.uint8)
    for x, y in (places + 1 + _MARGIN) * unit:
        cv2.circle(paper, (int(x), int(y)), int(0.3 * unit), 0, -1, cv2.LINE_AA)
    return paper, (1.0 + _MARGIN) * unit, (1.0 + _MARGIN) * unit


def poses(count: int, seed: int, away_m: float = 0.6) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Rotation and translation of boards before a camera, camera from board."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        turn = np.deg2rad(random.uniform((-30, -30, -15), (30, 30, 15)))
        rotation, _ = cv2.Rodrigues(turn)
        x, y = random.uniform(-0.18, 0.18, 2) * away_m
        yield rotation, np.array([x, y, away_m * random.uniform(0.85, 1.3)])


@cache
def _rays(camera: Camera) -> NDArray[np.float64]:
    """(pixels, 3) along which each pixel is seen."""
    u, v = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    pixels = np.column_stack((u.ravel(), v.ravel())).astype(float)
    return np.column_stack((camera.undistort(pixels), np.ones(len(pixels))))


def image_of(
    board: Board, camera: Camera, rotation: np.ndarray, shift: np.ndarray, noise: float = 2.0
) -> NDArray[np.uint8]:
    """What the camera sees of the board in this pose (camera from board, its middle at shift)."""
    paper, left, top = print_of(board)
    rays = _rays(camera)
    normal = rotation[:, 2]
    with np.errstate(divide="ignore", invalid="ignore"):
        far = (shift @ normal) / (rays @ normal)
    on_board = (rays * far[:, None] - shift) @ rotation
    middle = board.places()[:, :2].mean(axis=0)
    place = (on_board[:, :2] + middle) / board.unit_m * PX_PER_UNIT + (left, top) - 0.5
    place[~(far > 0)] = -9
    maps = np.float32(place.reshape(camera.height, camera.width, 2))
    # Twice as large and shrunk again would be smoother; a blur does for corners.
    seen = cv2.remap(cv2.GaussianBlur(paper, (0, 0), 1.5), maps, None, cv2.INTER_LINEAR,
                     borderMode=cv2.BORDER_CONSTANT, borderValue=140)  # fmt: skip
    random = np.random.default_rng(int(1e6 * abs(shift[0])) + 1)
    noisy = cv2.GaussianBlur(seen, (0, 0), 0.6) + random.normal(0, noise, seen.shape)
    return np.clip(noisy, 0, 255).astype(np.uint8)


def write_pairs(
    folder: Path, board: Board, pair: StereoCalibration, count: int = 9, seed: int = 1
) -> tuple[str, str]:
    """PNG pictures of the board by both cameras; the patterns that name them."""
    assert pair.right is not None
    for number, (rotation, shift) in enumerate(poses(count, seed)):
        left = image_of(board, pair.left, rotation, shift)
        right = image_of(
            board, pair.right, pair.rotation @ rotation, pair.rotation @ shift + pair.translation
        )
        cv2.imwrite(str(folder / f"left{number:02}.png"), left)
        cv2.imwrite(str(folder / f"right{number:02}.png"), right)
    return str(folder / "left*.png"), str(folder / "right*.png")


def lying(
    board: Board, camera: Camera = CAMERA, place: tuple[float, float] = (0.1, 2.0)
) -> NDArray[np.uint8]:
    """What a camera sees of a board on the floor, turned by 20 degrees."""
    rotation, centre = GROUND.world_from_camera
    turn, _ = cv2.Rodrigues(np.array([0.0, 0.0, np.deg2rad(20.0)]))
    # On the board x is right and y towards the camera, so that its z is down.
    world_from_board = turn @ np.diag([1.0, -1.0, -1.0])
    shift = rotation.T @ (np.array([*place, 0.0]) - centre)
    return image_of(board, camera, rotation.T @ world_from_board, shift)
