"""CVAT for video 1.1: XML, a `track` a person, a `box` a frame.

Frames count from 0 as the footage does. `xtl, ytl, xbr, ybr` are the edges of a box in pixels from
the picture's top left corner: a box over the first ten columns has `xtl` 0 and `xbr` 10, as left 0
and width 10 here, so nothing is shifted. A box with `outside` 1 says that the track is out of view
from this frame to its next box: a gap.

Written, every box stands in the file. `keyframe` is 0 where CVAT's own interpolation gives the same
box, which is where this program interpolated, and 1 elsewhere: CVAT drops the others on reading.
Read, keyframes are a person's rows (a tracker's in tracks whose source is `auto`), others are
interpolated. A track that is told by keyframes alone is filled in as CVAT does: straight from one
to the next, and held from the last one to the end of the task where no `outside` ends it.

CVAT numbers tracks anew; so each has an attribute `track_id`, which is taken where a file has it.
The attribute `name` is the person's, others are attributes of the track: one that is called `name`
or `track_id` here is written with a `_` behind. A `label` other than person is its class.
`occluded` is visibility 0, as is predicted, and below a half. The format has no places on the
floor. Source: CVAT's XML annotation format 1.1 and what CVAT 2 writes.
"""

from __future__ import annotations

from tracking.formats.cvat_reading import import_cvat, looks_like_cvat
from tracking.formats.cvat_writing import export_cvat
from tracking.formats.label_text import label_as_read
from tracking.formats.track_format import Content, TrackFormat

CVAT = TrackFormat(
    "cvat",
    "CVAT for video 1.1, XML",
    (".xml", ".zip"),
    looks_like_cvat,
    import_cvat,
    export_cvat,
    holds=frozenset(
        (Content.BOXES, Content.VISIBILITY, Content.SOURCES, Content.CLASSES, Content.NAMES)
    ),
    needs=Content.BOXES,
    label_as_read=label_as_read,
)
