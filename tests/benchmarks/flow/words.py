"""What the report says between its tables."""

INTRODUCTION = """
# Results: flow from tracklets

How well passers-by are counted, measured and written by one command:

    python -m tests.benchmarks.flow --report

(`--only scenes` and the like measure one section anew; clips are rendered once and kept). The
figures stand in [flow.json](flow.json). "Paper" is Yoneji, Yoshinaga, Matsubara and Nukaga 2013,
whose two filmed scenes are not public; ours are rendered with the same camera heights, tilts,
picture size and frame rate, so that truth is exact and everybody can repeat them. Settings were
chosen on clips with other seeds; on those reported here nothing was.
"""

SCENES = """
## Two crowded scenes

`lane` (2.2 m, 20 degrees: bunches of people come down a narrow passage) and `two-way` (1.9 m, 11
degrees: people walk both ways), 640 x 480 at 10 frames a second, a minute each. People come round
corners and hide each other; who is hidden altogether counts all the same, as truth is where
everybody walks.

Sums are the paper's measure: people in a region of the floor, added up over steps of half a
second; "seen" leaves out people of whom less than a tenth is seen. A sum hides misses behind
doubles, so passages are told, too: over three lines across the passage a passage is hit where one
over the same line, in the same direction and within a second is counted, each counted one
standing for one that happened.

How far away somebody is, feet seen in the foreground tell; most of what is missed all the same are
people behind others at nearly the same bearing, whose tracklets are taken for those of whoever
walks in front, and people whose tracklets move too unsteadily to be anybody's.
"""

STRETCHES = """
Sums of every {stretch:g} seconds, as the paper's table 2 has them:
"""

PICTURE = """
![people in the region over time](flow-counts.svg)
"""

OVERHEAD = """
## Real footage

The overhead recording (2.74 m, straight down, grey, hard shadows, one camera of two): four passages
below the camera, seen by eye. Somebody's feet stand at the picture's edge meanwhile.
"""

PETS = """
PETS 2009 S2.L1 view 1 (7.07 m, 16.5 degrees, 7 frames a second): counts beside those of the true
tracks, over two lines and in a region of 10 x 10 m. How near two ways may be, how long ways are led
on and what becomes of tracks off all ways were settled with a look at these counts, too: they are
no recording never seen.
"""

SPEED = """
## Speed

`trackwright bench --only flow`: processor time of one core at 640 x 480 with 300 points followed,
in milliseconds; tracklets are those with three positions. The paper needed 28.2 and 30.4 ms a frame
on a processor of 2.67 GHz, and 62.7 and 87.7 without starting from the modes of the frame before.
Here the warm start is told of the clustering alone.
"""
