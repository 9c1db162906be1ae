"""Many recordings: planned, handed out to workers, written down in a ledger, reported."""

from tracking.batch.array_script import array_script
from tracking.batch.ledger import Ledger, Row, read_rows
from tracking.batch.order import BatchOrder, Limits
from tracking.batch.outcome import Cause, Outcome, State
from tracking.batch.output_folder import Shard, batch_folder, ledger_path, merge_shard
from tracking.batch.progress import BatchState, Listener
from tracking.batch.recordings import (
    Entry,
    Found,
    find_recordings,
    named_entries,
    shard_of,
)
from tracking.batch.report import report_path, write_batch_report
from tracking.batch.runner import BatchRun
from tracking.batch.watch import StateFile, WatchedBatch, ask_to_stop, watch
from tracking.batch.worker_process import Doing
from tracking.batch.workers import LocalWorkers, Workers
