"""Files of other tools."""

from tracking.formats.catalogue import FORMATS, TrackFormat, format_named
from tracking.formats.mot import read_mot, write_mot
from tracking.formats.replacing import replacing

__all__ = ["FORMATS", "TrackFormat", "format_named", "read_mot", "replacing", "write_mot"]
