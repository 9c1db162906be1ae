"""Files of other tools."""

from tracking.formats.catalogue import FORMATS, TrackFormat, format_named
from tracking.formats.mot import as_truth, read_mot, write_mot
from tracking.replacing import replacing

__all__ = [
    "FORMATS",
    "TrackFormat",
    "as_truth",
    "format_named",
    "read_mot",
    "replacing",
    "write_mot",
]
