"""The colours of what is no track, told apart also by the colour-blind (Okabe and Ito 2008)."""

from __future__ import annotations

from typing import Final

from app.core.scenes.frame_scenes import Colour

ORANGE: Final[Colour] = (230, 159, 0)
SKY_BLUE: Final[Colour] = (86, 180, 233)
GREEN: Final[Colour] = (0, 158, 115)
YELLOW: Final[Colour] = (240, 228, 66)
VERMILION: Final[Colour] = (213, 94, 0)
PURPLE: Final[Colour] = (204, 121, 167)
