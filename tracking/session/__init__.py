"""The document, its HDF5 file, and what keeps both whole."""

from tracking.session.backup_restore import replace_damaged
from tracking.session.backups import Backup, check_backup, list_backups
from tracking.session.body_parts import corrected_parts, place_labels, session_samples
from tracking.session.document import Session
from tracking.session.edit_log import log_as_json, write_log_csv, write_log_json
from tracking.session.errors import RecordingMissing
from tracking.session.imported_session import session_of_import, take_into
from tracking.session.info import describe, recording_of
from tracking.session.known_recordings import KnownRecordings
from tracking.session.pending_edits import last_worked_on_s, read_history
from tracking.session.pending_save import PendingSave
from tracking.session.provenance import ids_by_now, parts_by_now
from tracking.session.reference import RecordingReference
from tracking.session.runs import Runs
from tracking.session.samples import boxes_of, places_of, samples_from, samples_with_boxes
from tracking.session.session_writer import find_backups
from tracking.session.store import is_open
from tracking.session.track_import import (
    IMPORTED,
    Importable,
    ImportOrigin,
    ImportWish,
    describe_footage,
    fit_to_recording,
)
from tracking.stamps import resolve_author
