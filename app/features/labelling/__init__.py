"""Labels that people draw and say: body parts, occluders, lines, regions, reviewed ranges."""
