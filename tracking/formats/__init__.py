"""Files of other tools."""

from tracking.formats.catalogue import FORMATS, TrackFormat, format_named
from tracking.formats.mot import as_truth, read_mot, write_mot
from tracking.formats.part_labels import GivenLabel, read_part_labels, write_part_labels
from tracking.formats.samples import read_samples, write_samples
from tracking.replacing import replacing

__all__ = [
    "FORMATS",
    "GivenLabel",
    "TrackFormat",
    "as_truth",
    "format_named",
    "read_mot",
    "read_part_labels",
    "read_samples",
    "replacing",
    "write_mot",
    "write_part_labels",
    "write_samples",
]
