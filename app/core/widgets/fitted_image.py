"""An image as large as there is room."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPixmap, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from tracking.arrays import Picture


class FittedImage(QLabel):
    """Shows an image with its proportions, scaled to the widget."""

    def __init__(self, name: str, parent: QWidget) -> None:
        """`name`: for screen readers."""
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setAccessibleName(name)
        self._whole = QPixmap()

    def show_image(self, image: Picture | None) -> None:
        """Show another image, (height, width, 3) BGR; None: nothing."""
        self._whole = QPixmap()
        if image is not None:
            packed = np.ascontiguousarray(image)
            height, width = packed.shape[:2]
            kind = QImage.Format.Format_BGR888
            self._whole = QPixmap.fromImage(
                QImage(packed.data, width, height, 3 * width, kind).copy()
            )
        self._fit()

    @property
    def is_empty(self) -> bool:
        """Whether it shows nothing."""
        return self._whole.isNull()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Fit the image anew."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        if self._whole.isNull():
            self.clear()
            return
        ratio = self.devicePixelRatioF()
        keep = Qt.AspectRatioMode.KeepAspectRatio
        smooth = Qt.TransformationMode.SmoothTransformation
        scaled = self._whole.scaled(self.size() * ratio, keep, smooth)
        scaled.setDevicePixelRatio(ratio)
        self.setPixmap(scaled)
