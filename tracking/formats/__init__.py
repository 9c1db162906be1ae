"""Files of other tools."""

from tracking.formats.catalogue import FORMATS, TrackFormat, format_named
from tracking.formats.mot import as_truth, read_mot, write_mot
from tracking.formats.part_labels import GivenLabel, read_part_labels, write_part_labels
from tracking.formats.samples import write_samples
from tracking.formats.samples_reading import begins_as_hdf5, is_hdf5, read_samples, samples_at
from tracking.replacing import replacing

__all__ = [
    "FORMATS",
    "GivenLabel",
    "TrackFormat",
    "as_truth",
    "begins_as_hdf5",
    "format_named",
    "is_hdf5",
    "read_mot",
    "read_part_labels",
    "read_samples",
    "replacing",
    "samples_at",
    "write_mot",
    "write_part_labels",
    "write_samples",
]
