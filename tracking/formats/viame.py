"""VIAME's CSV, which DIVE reads and writes, too: a line a detection, or a state of a track.

`id, video or picture, frame, left, top, right, bottom, confidence, length`, then pairs of a class
and its confidence, then attributes. Frames and pixels count from 0; `right` and `bottom` are edges,
so nothing is shifted. Lines that begin with `#` are comments; `# metadata` may tell `fps`.

- A track is what shares an id; id 0 becomes the id after the highest. Its class is the likeliest of
  its last line that has any, its confidence in each frame the eighth value, else the class's.
- `(trk-atr) KEY VALUE` belongs to the track: `name` is the person's, others are attributes. Of
  `(atr) KEY VALUE`, which belong to one frame, `occluded true` is visibility 0; others are left
  out, as are lengths, `(kp)`, `(poly)`, `(hole)`, `(mask)` and `(note)`.
- Written, a blank in KEY is `%20`, and an attribute called `name` has the key `name_`; attributes
  beyond 48 kB of a track are left out, as its lines could not be read back.
- Written, who is hidden (predicted, or of whom less than half is seen) has `(atr) occluded true`.
  The second value is the time in the video where the frames a second are known. A confidence nobody
  knows is 1; keyframes and places on the floor are not in the format.

Sources: VIAME's examples/detection_file_conversions/README.rst and its
read_/write_object_track_set_viame_csv; DIVE's server/dive_utils/serializers/viame.py.
"""

from __future__ import annotations

from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.viame_class import label_as_read
from tracking.formats.viame_reading import import_viame, looks_like_viame
from tracking.formats.viame_writing import export_viame

VIAME = TrackFormat(
    "viame",
    "VIAME and DIVE, CSV",
    (".csv",),
    looks_like_viame,
    import_viame,
    export_viame,
    holds=frozenset(
        (Content.BOXES, Content.CONFIDENCE, Content.VISIBILITY, Content.CLASSES, Content.NAMES)
    ),
    needs=Content.BOXES,
    label_as_read=label_as_read,
)
