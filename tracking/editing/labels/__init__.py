"""What people say: names, parts of bodies, occluders, lines, regions, what was looked at."""
