"""Label Studio's JSON of video: regions of the `VideoRectangle` tag, a region a track.

The file is an array of tasks, each with `annotations` (and `predictions`), whose `result` holds the
regions: `type` "videorectangle" and in `value` the `labels`, `framesCount` and the `sequence` of
keyframes. The smaller JSON_MIN has an array of records instead, a list of regions under the name of
each tag and no ids of regions. Written is the full one, with an annotation.

- A keyframe has `frame` (from 1), `x, y, width, height` in percent of the picture and `rotation` in
  degrees around its top left corner. Boxes lie straight between keyframes. From a keyframe that is
  not `enabled` on the region is out of view, though the keyframe itself is shown; after the last
  one that is enabled, it stays as it is until `framesCount`.
- A box that is turned becomes the upright box around it.
- The picture's size is `original_width` and `original_height` where a file has them; Label Studio
  leaves them out for videos, and then the recording tells it.
- Regions are called by random texts. Those written here are called `track-7`, which keeps the id on
  its way through Label Studio; others get free ids, by their order. The texts of a region's `meta`
  are the person's name, then attributes as `KEY: VALUE` (`%3A` in KEY is a colon before a blank);
  its label is the class. `origin` is "prediction" where a tracker placed a whole track.
  Who is hidden is not in the format.
- Of several annotations of a task the one marked as ground truth is read, else the newest. Rows of
  predictions are a tracker's.

Label Studio counts frames by the `framerate` of its Video tag (24 unless it is set), whatever the
footage has; what a file says of it is compared with the recording. Put the address that Label
Studio finds the video at into `data.video` of a file that is written.

Sources: Label Studio's VideoRegion.js, VideoRectangleRegion.js (lifespans, shapes between
keyframes) and props.ts; label-studio-sdk's extract_key_frames and converter (JSON_MIN), and its
import of PathTrack.
"""

from __future__ import annotations

from tracking.formats.label_studio_reading import import_label_studio, looks_like_label_studio
from tracking.formats.label_studio_writing import export_label_studio
from tracking.formats.label_text import label_as_read
from tracking.formats.track_format import Content, TrackFormat

LABEL_STUDIO = TrackFormat(
    "label-studio",
    "Label Studio video, JSON",
    (".json",),
    looks_like_label_studio,
    import_label_studio,
    export_label_studio,
    in_percent=True,
    holds=frozenset((Content.BOXES, Content.SOURCES, Content.CLASSES, Content.NAMES)),
    needs=Content.BOXES,
    label_as_read=label_as_read,
)
