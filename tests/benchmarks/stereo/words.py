"""What the report says between its tables."""

from __future__ import annotations

from tests.benchmarks.stereo import reasons
from tests.benchmarks.stereo.clips import FIRST_FRESH

INTRODUCTION = f"""
# Results: stereo trackers

How well people are followed by two cameras, measured and written by one command:

    python -m tests.benchmarks.stereo --report

(five hours on one core, four of them to render the clips; `--only tables` and the like measure one
section anew; clips and runs are kept for as long as nothing they were made with changes). The
figures stand in [stereo.json](stereo.json), everybody who was not kept in the clips measured often
among them. "Paper" are
Kawashita and others 2012 and 2014, measured by their authors in scenes of their own that are not
public; ours are rendered with the same camera heights, tilts and resolution, so that truth is exact
and everybody can repeat them. Settings were chosen on clips with other seeds.

Two sets of clips are reported. Those *measured often* (seeds from 6101 on) have been measured
after each change, so that they are no longer unseen and flatter. *Fresh* ones (seeds from
{FIRST_FRESH} on) nobody had looked at when they were measured: goals are judged on them, and
trackers are chosen by them.

A person is *kept*, as in the papers, if the id given at the first detection stays: every match of
the person bears it, nobody else bore it before or between, and it is matched in at least half of
the person's frames from the first match on. Boxes match at an overlap (IoU) of one half.
"Tracking accuracy" is the share of the people detected who are kept. Behind it, in brackets, stands
Wilson's 95 % interval: it is wide with some forty people, and so were the papers'.
"""

TABLES = """
## Both papers' tables

Tracking accuracy on the clips measured often, 30 s each, at least 30 people a scene. The three
methods of cues are the papers' own and nothing of ours (`--set paper=true --set
velocity_average_s=1 --set process_noise_m=0.15`, the last two chosen for them on other clips;
weights of cues that are left out are 0). What they are given to see, the regions of people, is
ours in all rows. `stereo-joint` is our default, as it comes.

"By box" matches tracks and people whose boxes overlap by half, with the 95 % interval in brackets.
The papers' authors judged by eye. This is stricter: somebody whose box is covered for a moment
by the box of another track is not kept. "By place" leaves such matches out, so that a track counts
for a person only in frames in which it stands nearer to that person than to anybody else.
"""

OF_2012 = """
Kawashita and others 2012, by `stereo-colour`, direction by `stereo-direction`:
"""

OF_2014 = """
Kawashita and others 2014, and people in clothes of one colour, which neither paper has, by
`stereo-direction`:
"""

CUES = """
Cues that kept nobody more, told by comparing people one by one, by what went wrong with them first
and where they were then ("beside somebody" is within a metre of somebody and in full sight). All
that a cue decides is which track gets which detection, so that swapped, track taken over and second
track are a cue's to decide.
"""

WHY_HEAD = """
Why, by what was looked at frame by frame:
"""

WHY = {
    reasons.DOUBLED: """
A second track takes over. Once a person is seen in two pieces, the other piece is somebody new
there and then, as the papers have it, and that track walks on within half a metre. By distance
alone it gets nothing more and ends. With colour it takes over in the first frame in which it
happens to look more like the person: the papers add distances of colours to metres as they are, the
person's own came to 0.4 to 1.3 and changed by 0.25 and more in one frame of twenty, while both
tracks' places differed by 0.2 to 0.4 m. Hues of grey clothes are noise, and the paper of 2012
counts them like all others. `stereo-joint` weighs each cue by how much it tells.
""",
    reasons.SWAPPED: """
Tracks go from one person to another. Where people pass each other, their regions touch or one is
half hidden, and for a frame all that is seen of one is a piece of their outline, with colours like
nobody's. Added to metres as they are, colours then outweigh half a metre, and both are paired
crosswise.
""",
    reasons.FALSE: """
Nothing changes where no cue is asked. Cues only decide which track gets which detection within
reach. They have no say in a false match (two boxes overlap when they are scored), in an old track
(somebody who left is still waited for as a newcomer arrives), or in a new id (nothing was seen for
longer than anybody is waited for).
""",
}
"""Reasons by what went wrong."""

TRACKERS = """
## Which tracker to take

All trackers for two cameras as they come, at their defaults, on the fresh clips (seeds {seeds}).
Rows match by box, at an overlap of one half; misses and false alarms are in per cent of the boxes
of the truth. The error is the distance on the floor. The time is processor time of following alone,
finishing the run included, on the machine that measured all of it; finding the people, which is the
same for all three, took {seeing_ms:.1f} ms a frame there. How the trackers for one camera do is
told on [pages of their own](../results.md).
"""

BY_SCENE = """
Who is kept, and IDF1, scene by scene:
"""

GOALS = """
## Goals

`stereo-joint` as it comes. Goals are judged with rows that match by box, at an overlap of one half;
"by floor" they match on the floor, within {floor_m:g} m, as with `score --match floor`. Boxes are
stricter: two that cover each other may be taken one for the other in a frame or two, which then
counts as a lost id, though both tracks stand where their people do. Counting by floor was added
once the fresh clips' figures by box were known.

"Fresh" are clips with seeds that nobody had looked at when they were measured, four times as many
as of those measured often: once figures of them have been seen and a tracker is changed, later
seeds take their place. The intervals take each person by itself; people of a clip share its crowds,
so that the true ones are wider.

"Detected" is the share of the people visible for a second who were matched in ten frames; visible
means that at least three tenths of the person are seen, in every frame of that second. The error is
the distance on the floor between track and truth, whose place is where the person stands.
"""

NOT_FRESH = """
Goals are judged on fresh clips, and those have not been measured since a tracker was last changed.
"""

FURTHER = """
More of the fresh clips. Misses and false alarms are in per cent of the boxes of the truth.
"""

PEERS = """
## Identity switches beside other trackers

The same detections for everybody. Rows match by place, on the floor within {radius:g} m, and not by
box as above, so that a clip may have other figures here. The others get places and boxes, no
colours, with settings chosen as well as we could on other seeds for each kind of clip (`python -m
tests.benchmarks.tracker_peers.parameter_search crossing`, or `rendered --recordings CLIP...`),
while ours keep one setting for all. "As they come" are rows told frame by frame, as the others
tell theirs; "finished" is the run looked over as a whole, as our tracker comes. Time is processor
time of following alone.
"""

KINDS = {
    "crossing": "15 walkers who cross on a floor, 3 x 1000 frames, places off by 6 cm:",
    "rendered": "Rendered scenes as our perception sees them: {clips}.",
}

REAL = """
## Real footage

The overhead recording (two cameras 7.4 cm apart, 2.74 m, straight down, grey, hard shadows and sun
flecks, 627 frames; the exposure settles until about frame 60): four people pass, one after the
other. When they do was seen by eye, so the first and last frames are not exact; people are only
partly in the picture then.
"""

NO_REAL = """
## Real footage

Not measured: the overhead recording is not beside the checkout, nor where `--data` or
TRACKWRIGHT_DATA says.
"""

LOST = """
## What goes wrong

Everybody our tracker did not keep in the clips measured often, since those may be looked at, by
what went wrong first, read off truth and tracks by a script (`python -m
tests.benchmarks.stereo.lost_people CLIP...` tells each of them by clip, person and frame):
"""

WHERE = """
And where they were then, when least of them was seen{beside}:
"""

BESIDE = '; "beside somebody" is within a metre of somebody and in full sight'

PICTURE = """
![people who were not kept, before, while and after it went wrong](stereo-lost.jpg)

{captions} White is the person's true box, green the track it had, magenta the one it got,
grey everybody else's.
"""

ROBUSTNESS = """
## Light that changes, a right camera that fails or lags, poor cameras

A part of the light goes out within a second (clips of 15 s), or the right camera of a clip of 30 s
is late or ahead by frames throughout, dark, or shows one picture for four seconds from the twelfth
on; or, throughout, both cameras are noisy or see lamps flicker, or the right one is out of focus or
not level with the left one. "Longest alone" is the longest stretch in which a track stands where
nobody is within a metre. Rows match by box; the clips are the first of those measured often.
"""

WORDS = """
In these sentences:
"""

MEANINGS = {
    reasons.SWAPPED: "two people exchanged their tracks",
    reasons.TAKEN: "a track went from one person to another; both count",
    reasons.INHERITED: "a newcomer was given the track of somebody who had left or was lost",
    reasons.FALSE: "a track that stood on somebody else counted for a while, as boxes overlap",
    reasons.DOUBLED: "a second track on the same person took over",
    reasons.RENAMED: "lost and found again under a new id",
    reasons.LOST: "followed for less than half of the time",
    reasons.NEVER: "visible for a second and never detected",
}
