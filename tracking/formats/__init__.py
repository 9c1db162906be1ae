"""Files of other tools."""

from tracking.formats.catalogue import (
    FORMATS,
    format_named,
    format_of,
    readable_formats,
    track_endings,
)
from tracking.formats.losses import losses
from tracking.formats.measurable import Measurable, measurable
from tracking.formats.mot import people_in_mot, read_mot
from tracking.formats.mot_writer import write_mot
from tracking.formats.part_labels import GivenLabel, read_part_labels, write_part_labels
from tracking.formats.read_result import BadRow, Filmed, Imported, Stated
from tracking.formats.samples import sample_files, write_samples
from tracking.formats.samples_reader import begins_as_hdf5, is_hdf5, read_samples, samples_at
from tracking.formats.track_format import TrackFormat
from tracking.formats.track_writer import Exported
from tracking.progress import no_progress
