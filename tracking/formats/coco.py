"""COCO for video, in the layout of TAO: one JSON file a video.

`images` (one a frame, `frame_index` from 0), `videos`, `tracks` (`id`, `category_id`) and
`annotations` (`image_id`, `track_id`, `bbox`). A `bbox` is left, top, width and height in pixels
whose first is 0: as boxes are here, so nothing is shifted. `iscrowd` 1 marks what is not counted,
which is confidence 0 here. `attributes` of an annotation hold its `track_id` once more, where
datumaro and CVAT look for it. Source: TAO's toolkit, tao.py; COCO's data format.

What a track has besides its category (a name, attributes) stands in its `tracks` entry, under
keys of this program; other tools pass over them. The format has no places on the floor and no
keyframes.
"""

from __future__ import annotations

from tracking.formats.coco_reading import import_coco, looks_like_coco
from tracking.formats.coco_writing import export_coco
from tracking.formats.label_text import label_as_read
from tracking.formats.track_format import Content, TrackFormat

COCO = TrackFormat(
    "coco",
    "COCO for video (TAO), JSON",
    (".json",),
    looks_like_coco,
    import_coco,
    export_coco,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.CONFIDENCE, Content.CLASSES, Content.NAMES)),
    needs=Content.BOXES,
    label_as_read=label_as_read,
)
