"""What the report says between its tables."""

INTRODUCTION = """
# Results: spheroids on the floor

How well one camera follows people, measured and written by one command:

    python -m tests.benchmarks.spheroid --report

(`--only marks` and the like measure one section anew; clips are rendered once and kept). The
figures stand in [spheroid.json](spheroid.json). "Paper" is Waechter, Pustka and Klinker 2013,
measured by its authors in their office; ours are rendered after its description, so that truth is
exact and everybody can repeat them. Settings were chosen on clips with other seeds; on those
reported here nothing was.
"""

MARKS = """
## People on marked spots

Scenes `marks`, `marks-walking` and `marks-pairs`, {clips} people or pairs in turn: a camera 3.6 m
above the floor that looks straight down, 640 x 480 at 15 frames a second, everybody in a red top
and brown trousers. The paper's picture of its ten spots gives no coordinates. Ours: the outer
ones (1) lie where heads are outside of the picture, and whoever stands at the inner one (2) of a
pair hides a part of the one at the outer. The error is the distance on the floor between track
and truth, over the seconds in which people stand still, mean ± deviation in cm; beside it the
share of frames in which somebody follows.
"""

PICTURE = """
![four people who cross, two who change places](spheroid-situations.jpg)

Four who cross half round the middle, and two who change places at the edge: hypotheses in the
colour of their track, each person's own spheroid in white.
"""

WALKING = """
### Walking from mark to mark

"Across" is the paper's measure, the distance from the straight line between two marks; "error" is
the distance from where the person is at that moment, which the paper could not know.
"""

SITUATIONS = """
## Fifteen hard situations

The paper rates its fifteen situations by three experts but does not say what happens in them. The
scenes `situation-1` to `situation-15` have as many of each difficulty, everybody dressed alike. A
track that goes from one person to another is swapped (two that change places count twice);
renamed is who was lost and found again under a new id; missed is who was followed in less than
half of the frames. People of whom less than three tenths are seen do not count.
"""

PLACES = """
## One camera beside two

Scenes that are made for two cameras, {seconds:g} s each, with the left camera alone (`spheroid`,
`three-part`) and with both (`stereo-direction`), on the same truth, matched on the floor within
{radius:g} m. Here and on the real footage above one sees which of the two is the better default
for one calibrated camera.
"""

REAL = """
## Real footage

PETS 2009 S2.L1 view 1 (one camera, 7 frames a second, 19 people), no learned detector, matched on
the floor within {radius:g} m.
"""

ROBUSTNESS = """
## When something is out of the ordinary

A recording that begins with people in it (`--begin`), a part of the light that goes out
(`--dim`), a camera that is knocked for good (`--bump`, 1.5 degrees up and 1 degree about its
axis). A ghost is a track with nobody within a metre for more than {longest:g} s at a stretch.
"""

SPEED = """
## Speed

`trackwright bench --only spheroid`: processor time of one core at 640 x 480, 300 hypotheses a
person. `likelihoods_ms_k` are the weights of k people, `ms_a_person` the slope of their cost over
the people and `linear_r2` how well a straight line fits it; `fps` is everything with ten people
in the picture, from decoded frames to tracks.
"""
