"""PNG files small enough for a repository."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPixmap

_COLOURS = 255
_SAMPLES = 40_000


def save_small(pixmap: QPixmap, path: Path) -> None:
    """Save with a palette of its own colours, dithered; about a third of the size."""
    image = pixmap.toImage().convertToFormat(QImage.Format.Format_RGB32)
    table = [0xFF000000 | int(r) << 16 | int(g) << 8 | int(b) for b, g, r in _palette(image)]
    indexed = image.convertToFormat(
        QImage.Format.Format_Indexed8, table, Qt.ImageConversionFlag.ThresholdDither
    )
    if not indexed.save(str(path), "PNG", 0):
        raise SystemExit(f"{path} cannot be written")


def _palette(image: QImage) -> NDArray[np.uint8]:
    """(n, 3) blue, green, red of the colours that matter most in the picture."""
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4)
    pixels = rows[:, : image.width(), :3].reshape(-1, 3)
    rng = np.random.default_rng(0)
    chosen = pixels[rng.integers(0, len(pixels), _SAMPLES)].astype(np.float32)
    common, counts = np.unique(pixels, axis=0, return_counts=True)
    flat = common[np.argsort(counts)[-48:]]  # the window's own plain colours stay exact
    cv2.setRNGSeed(0)
    stop = (cv2.TERM_CRITERIA_MAX_ITER, 12, 0.0)
    flags = cv2.KMEANS_PP_CENTERS
    _, _, centres = cv2.kmeans(chosen, _COLOURS - len(flat), None, stop, 1, flags)
    return np.concatenate((flat, centres.round().astype(np.uint8)))
