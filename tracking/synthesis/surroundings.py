"""Floors and lights that several scenes share."""

from tracking.synthesis.specs import FloorSpec, LampSpec

STONE = FloorSpec((0.6, 0.6), (0.50, 0.46, 0.42))
LIGHT_STONE = FloorSpec((0.8, 0.8), (0.55, 0.52, 0.47), variation=0.05)
SLABS = FloorSpec((0.9, 0.6), (0.40, 0.375, 0.34), 0.10, 0.20, staggered=True)
PAVERS = FloorSpec((0.4, 0.2), (0.36, 0.30, 0.26), 0.14, 0.18, staggered=True)
ASPHALT = FloorSpec((0.0, 0.0), (0.20, 0.20, 0.205), 0.0, 0.30)
VINYL = FloorSpec((0.5, 0.5), (0.42, 0.43, 0.40), 0.03, 0.08)

SKYLIGHT = LampSpec((0.45, -0.25, -1.0), (0.52, 0.50, 0.46), (0.45, 0.47, 0.50), 0.09)
CEILING_LAMP = LampSpec((-0.35, -0.30, -1.0), (0.50, 0.47, 0.42), (0.47, 0.48, 0.50), 0.10)
SUN = LampSpec((0.75, -0.40, -1.0), (0.66, 0.62, 0.53), (0.34, 0.38, 0.44), 0.035)
HIGH_SUN = LampSpec((-0.55, 0.25, -1.0), (0.64, 0.61, 0.54), (0.36, 0.39, 0.45), 0.04)
