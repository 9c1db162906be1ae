"""The program that the sweep of batches kills: `python -m tests.sweeps.batch_driver TOP OUT N`.

It does a batch of the recordings in TOP with N workers, of which some recordings are bad.
"""

from __future__ import annotations

import sys
from pathlib import Path

from tests.batch.batches import QUICK, entries_of
from tracking.batch import BatchRun, Limits, LocalWorkers, batch_folder, write_batch_report

FAULTY = ("-m", "tests.batch.faulty_worker")
LIMITS = Limits(stall_s=30.0, memory_bytes=400 << 20)


def main(top: Path, out: Path, workers: int) -> None:
    """Do what is left of the batch."""
    folders = sorted(each for each in top.iterdir() if each.is_dir())
    with batch_folder(out) as ledger:
        run = BatchRun(ledger, out, QUICK, LIMITS)
        if run.plan(entries_of(*folders)).to_do:
            run.work(LocalWorkers(workers, LIMITS, FAULTY))
        write_batch_report(ledger, out)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]))
