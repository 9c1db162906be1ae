"""X-AnyLabeling's JSON: a folder with a file a frame, beside the pictures or in one of its own.

A file holds `imageHeight`, `imageWidth` and `shapes`, each with `label`, `points` in pixels,
`shape_type`, `group_id`, `score`, `difficult`, `description` and `attributes`. LabelMe's files are
of the same kind and are read, too.

- A track is what shares a `group_id`; id 0 becomes the id after the highest. Shapes without one are
  left out, which is told.
- A rectangle's points are its edges (four corners; two opposite ones before version 2.2). Of
  polygons, turned rectangles, quadrilaterals, circles and cuboids the box around them is read.
  Points and lines, such as those of a body that share the group of its box, are left out.
- `difficult` marks what does not count, which is confidence 0 here; else `score` is the confidence.
- `description` is the person's name, a `label` other than person its class, `attributes` are those
  of the track.
- The frame is the place of a file's picture among the pictures of the folder, in natural order, as
  X-AnyLabeling shows them. Without pictures it is the number in the file's name, as X-AnyLabeling
  tells frames when it exports MOT: the digits behind the last underscore.

Written, files are called as X-AnyLabeling calls the frames it takes out of a video
(`frame_00000.json`); a frame without boxes has none. The folder must be new, or empty. Gaps stay
gaps; keyframes and places on the floor are not in the format.

Sources: X-AnyLabeling's label_file.py, shape.py, schema.py (the members of a file), utils/video.py
(names of frames), utils/qt.py (order), label_converter.py (custom_to_mot).
"""

from __future__ import annotations

from tracking.formats.label_text import label_as_read
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.xanylabeling_folder import holds_frames, looks_like_frame
from tracking.formats.xanylabeling_reading import import_xanylabeling
from tracking.formats.xanylabeling_writing import export_xanylabeling

X_ANYLABELING = TrackFormat(
    "x-anylabeling",
    "X-AnyLabeling, a folder of JSON",
    (".json",),
    looks_like_frame,
    import_xanylabeling,
    export_xanylabeling,
    recognises_folder=holds_frames,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.CONFIDENCE, Content.CLASSES, Content.NAMES)),
    needs=Content.BOXES,
    label_as_read=label_as_read,
)
