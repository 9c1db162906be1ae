"""A new session file on its way to the disk."""

from __future__ import annotations

import os

from tracking.hdf5_image import Hdf5Image
from tracking.session.seal import beside, seal


class ImageFile(Hdf5Image):
    """A session's file, which ends with the user's seal."""

    def seal(self) -> None:
        """End the file with the user's seal on everything but the packed pieces."""
        pieces = self.pieces()
        size = self.seek(0, os.SEEK_END)
        structure = (self.held_between(*part) for part in beside(pieces, size))
        self.write(seal(size, pieces, structure))
