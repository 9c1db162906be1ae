"""The document, its HDF5 file, and what keeps both whole."""

from tracking.session.backup_restore import replace_damaged
from tracking.session.backups import Backup, check_backup, list_backups
from tracking.session.body_parts import corrected_parts, labels_in_place, session_samples
from tracking.session.document import Session
from tracking.session.edit_log import log_as_json, write_log_csv, write_log_json
from tracking.session.errors import RecordingMissing
from tracking.session.info import describe, recording_of
from tracking.session.known_recordings import KnownRecordings
from tracking.session.pending_edits import read_history, worked_on_s
from tracking.session.pending_save import PendingSave
from tracking.session.provenance import ids_by_now, parts_by_now
from tracking.session.reference import RecordingReference, SourceFingerprint
from tracking.session.runs import Runs
from tracking.session.samples import boxes_of, places_of, samples_from, samples_with_boxes
from tracking.session.session_writer import find_backups
from tracking.session.stamps import author_named
from tracking.session.store import is_open
from tracking.session.track_import import (
    IMPORTED,
    Importable,
    ImportOrigin,
    ImportWish,
    filmed_by,
    importable,
    session_of_import,
    take_into,
)

__all__ = [
    "IMPORTED",
    "Backup",
    "ImportOrigin",
    "ImportWish",
    "Importable",
    "KnownRecordings",
    "PendingSave",
    "RecordingMissing",
    "RecordingReference",
    "Runs",
    "Session",
    "SourceFingerprint",
    "author_named",
    "boxes_of",
    "check_backup",
    "corrected_parts",
    "describe",
    "filmed_by",
    "find_backups",
    "ids_by_now",
    "importable",
    "is_open",
    "labels_in_place",
    "list_backups",
    "log_as_json",
    "parts_by_now",
    "places_of",
    "read_history",
    "recording_of",
    "replace_damaged",
    "samples_from",
    "samples_with_boxes",
    "session_of_import",
    "session_samples",
    "take_into",
    "worked_on_s",
    "write_log_csv",
    "write_log_json",
]
