"""Types of arrays that many modules name; docstrings say their shapes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Float32s = NDArray[np.float32]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]
Rows = NDArray[np.intp]
"""Numbers of rows."""
Mask = NDArray[np.uint8]
"""(height, width), not 0 where it counts."""
Picture = NDArray[np.uint8]
"""(height, width, 3) BGR, or (height, width) grey."""
