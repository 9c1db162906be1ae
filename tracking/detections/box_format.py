"""A format of detections: files of boxes that another program found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from tracking.detections.box_collector import BoxCollector
from tracking.detections.coco_boxes import is_coco, read_coco_boxes
from tracking.detections.frame_numbers import Footage
from tracking.detections.mot_boxes import read_mot_boxes
from tracking.detections.yolo_boxes import read_yolo_boxes
from tracking.formats.mot import is_mot


@dataclass(frozen=True, slots=True)
class BoxFormat:
    """A format of detections.

    Attributes:
        name: as sessions and reports have it. title: what people call it.
        read: takes the boxes of a file in, that are of some footage.
        recognises: whether a file is of it, by its first `HEAD_BYTES` bytes; never raises.
    """

    name: str
    title: str
    read: Callable[[BoxCollector, Footage], None]
    recognises: Callable[[bytes], bool]


COCO = BoxFormat("coco", "COCO JSON", read_coco_boxes, is_coco)
MOT = BoxFormat("mot", "MOTChallenge text", read_mot_boxes, is_mot)
YOLO = BoxFormat("yolo", "YOLO text", read_yolo_boxes, lambda _: False)
"""A folder of files, which its endings tell."""
