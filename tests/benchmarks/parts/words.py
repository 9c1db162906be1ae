"""What the report says between its tables."""

INTRODUCTION = """
# Results: body parts

Measured on rendered scenes with exact part truth, written by one command:

    python -m tests.benchmarks.parts --report

(half an hour on one core; `--only rates` and the like measure one section anew; runs over clips are
kept for as long as nothing they were made with changes). The figures stand in
[parts.json](parts.json). "Paper" is Zhao and Lee 2009, measured by its authors on 20 filmed
clips that are not public; ours are rendered, so that truth is exact and everybody can repeat them.
Settings were chosen on scenes with other seeds, and the built-in failure detector was trained on
others again; on the scenes reported here nothing was chosen.

The other systems have pages of their own: [stereo](stereo.md), and with one calibrated
camera [spheroids](spheroid.md) and [flow](flow.md).
"""

HOW_RATES = """
## Parts and people over time

{clips} clips of the scene `walkway` (`trackwright synth --scene walkway`; the seeds of all clips
stand in `tests/benchmarks/parts/clips.py`), 720 x 480 at 20 frames a second, camera at 3 m under 30
degrees, 100 people, up to five at once who meet, cross and hide each other, cast shadows, a wall
behind.

The paper's measure: a part is right while less than half of its rectangle holds something else.
With exact truth we take it strictly: whatever lies outside of the box of that part of that person
is something else, another part of the same person too; a rectangle that covers less than a
twentieth of its part is wrong. A person's first frame is the first one in which the whole person is
in the picture, at least seven tenths seen, and a track stands on the person; a person without a
track within a second is wrong from the start, and so is everything after an id changed or a track
ended. A person counts until it leaves the picture, so later frames have fewer people. The person's
rectangle is the box round the three parts.

"At frame i" is the share of the people still in view whose part is right i frames after their
start, as in the paper, whose curves rise where a part is found again. Behind ± is half of Wilson's
95 % interval: two trackers, or two sets of clips, that differ by less may differ by chance.
"""

SHORT = """
"With adjustment" is the tracker as it comes. "The paper's adjustment" (`--set
fit_silhouettes=false --set pose_constraints=false --set reidentify=false`) puts back only what the
failure detector finds, as the paper does; ours draws parts of people seen alone to their
silhouettes, too, puts parts back that stand where no part of a body can, and looks for people it
lost. "Without" (`--set adjust=false`) is colours alone. "Joint" is `three-part-joint`: as good by
this measure, and better where a part shall never be lost for a moment. Births, ends and who is
occluded are the same in all of them, and that alone keeps more parts than the paper's tracker had
without adjustment: the torso, large and of one cloth, is seldom lost by colours, so the gain cannot
be what it was there.

What is lost is lost among people who hide each other. In these scenes every second person's way is
planned to cross another's, up to five within a few metres, and some walk in as one bunch.
"""

PICTURE = """
![two frames of the first clip, with adjustment and without](parts-walkway.jpg)

The first clip, 150 and 190 frames in: with adjustment on the left, without on the right. Yellow is
the head, green the torso, blue the hip-leg; thin is occluded, red judged lost.
"""

SHADOWS = """
### Shadows

The scenes have a sun and shadows as long as people. How much of the rectangles lies outside of
their part, on average; a shadow taken for legs would show in the last column.
"""

CROUCHING = """
## People who crouch and bend

The paper leaves them open. {clips} clips of the scene `crouching`: people stop, crouch or bend over
for a while and stand up again. Kept: a second after standing up the same track stands on the
person. Times are counted from the frame in which the person is upright again.
"""

EQUALISATION = """
## Equalised histograms

False alarms of the part histograms, as in the paper: 50 pictures, 1000 random regions each that do
not overlap the part.
"""

DETECTOR = """
## The failure detector

The built-in detector was trained by `python -m tests.benchmarks.parts.detector` on {recordings}
clips with {people} people seen by eight cameras, labelled from truth, none of them among those
reported here. It learns from a tracker that adjusts nothing, and only from moments in which a
tracker asks it: no part of the person is occluded, and the track has not changed hands. On and off
are its samples on and off their part. Areas and "found at" are of people held out in training, all
of one person's tracks together. The last columns are the detector as it ships on {clips} clips it
never saw, from the same eight cameras. "Several" tells several lost parts from one, and stands
where both answers are right equally often; its false alarms are single losses taken for several.

It was set to two false alarms in a hundred among people held out; on other clips there may be a
few more. Most of what is missed are parts that slid a little and still stand as parts of a body do.
Few torsos are ever lost, so that machine has least to learn from. Its scores are scikit-learn's to
1e-10, many times faster (`python -m tests.benchmarks.parts.detector_speed`); what is in its file
is told in [detector-file.md](../detector-file.md).
"""

REAL = """
## Real footage

Two public sequences with true boxes of people (PETS 2009 S2.L1 view 1, 7 frames a second; TUD
Campus, 71 frames). Nobody has drawn parts there: a part is taken for right while less than half of
its rectangle lies outside of its zone of the person's box (head: upper quarter, torso: from a tenth
to six tenths down, hip-leg: lower six tenths). Counted 100 frames after a person's start, or in the
last frame in view where a person leaves earlier; "throughout": in nine of ten frames until then.
The footage is not ours to show; where it is at hand, pictures of it with parts drawn are made by

    python -m tests.benchmarks.parts --data FOLDER --pictures SOMEWHERE

What fails there: far people are joined to near ones, dark trousers on dark ground are taken for
shadow, and strides as wide as the body is high are cut off at the hip. Most who leave before 100
frames do so because the footage ends or they walk out.
"""

SPEED = """
## Speed

`trackwright bench --only parts`: {fps:.1f} frames a second of processor time on one core of a
shared machine with two and without an accelerator, 720 x 480, from the video file to parts and
particles, over {frames} frames in which five people are tracked. Filters, failures, births and
boxes are steps within the tracker, whose rest are colours and columns.
"""
