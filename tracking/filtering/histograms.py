"""How much two colour histograms differ."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def bhattacharyya_distance(
    models: NDArray[np.float32], seen: NDArray[np.float32]
) -> NDArray[np.float64]:
    """The distance of every model to every histogram seen: (people, detections), in 0 to 1.

    `rho = sum_u sqrt(p_u q_u)`, `Dc = sqrt(1 - rho)` ([Kawashita2012] eq. 3 and 4).

    Args:
        models: (people, bins), rows sum to 1. seen: (detections, bins), rows sum to 1.
    """
    rho = (np.sqrt(models) @ np.sqrt(seen).T).astype(np.float64)
    return np.sqrt(np.clip(1.0 - rho, 0.0, 1.0))
