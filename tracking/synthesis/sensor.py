"""What a camera adds to the light it is given: vignetting, gain, noise, 8 bits."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image

Float32s = NDArray[np.float32]

_GAINS = (1.0, 0.965)  # the cameras are never quite alike
_OFFSETS = (0.0, 0.4)  # grey levels
_VIGNETTE = 0.09  # darkening in the corners
_READ_NOISE = 0.9  # deviation in the dark, grey levels
_SHOT_NOISE = 0.004  # and what it grows by with each grey level
_BANK = 1 << 18


class Sensor:
    """One camera's sensor."""

    def __init__(self, size: tuple[int, int], side: int, seed: int) -> None:
        """A sensor for images of `size` (width, height); camera 0 is left, 1 right."""
        self._size, self._side, self._seed = size, side, seed
        self._response = self._light_response()
        rng = np.random.default_rng((seed, 77, side))
        # Drawing fresh noise costs more than all the rest: each frame reads this from elsewhere.
        samples = max(_BANK, 3 * self._response.size)
        self._noise = rng.standard_normal(samples, dtype=np.float32)

    def expose(self, light: Float32s, frame: int) -> Image:
        """The 8-bit picture of light (height, width, 3), 0..1 and linear, in a frame."""
        grey = np.asarray(cv2.multiply(light, self._response), np.float32)
        np.sqrt(np.maximum(grey, 0.0, out=grey), out=grey)
        grey *= np.float32(255)
        grey += np.float32(_OFFSETS[self._side])
        rng = np.random.default_rng((self._seed, self._side, frame))
        first = int(rng.integers(0, len(self._noise) - grey.size))
        noise = self._noise[first : first + grey.size].reshape(grey.shape)
        spread = grey * np.float32(_SHOT_NOISE)
        spread += np.float32(_READ_NOISE)
        grey += np.asarray(cv2.multiply(noise, spread), np.float32)
        return np.asarray(cv2.convertScaleAbs(np.maximum(grey, 0.0, out=grey)), np.uint8)

    def _light_response(self) -> Float32s:
        """Gain and vignetting (height, width, 3)."""
        width, height = self._size
        x = np.linspace(-1, 1, width)[None] * width / np.hypot(width, height)
        y = np.linspace(-1, 1, height)[:, None] * height / np.hypot(width, height)
        falloff = _GAINS[self._side] * (1.0 - _VIGNETTE * (x**2 + y**2))
        return np.repeat(falloff.astype(np.float32)[..., None], 3, axis=2)
