"""Embeddings of people by a network, as trackers ask for them."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

Embeddings = NDArray[np.float32]


class Embed(Protocol):
    """Describes the people in boxes of the picture that is looked at."""

    def __call__(self, box: NDArray[Any], /) -> Embeddings:
        """(n, d) of unit length each, of boxes (n, 4) in px of the left picture as recorded.

        Those of one person are alike, whatever the pose. NaN where a box shows too little.
        """
