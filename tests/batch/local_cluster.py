"""A Dask cluster in one process, until its input ends: `python -m tests.batch.local_cluster`.

It prints the address of its scheduler.
"""

from __future__ import annotations

import sys

from distributed import LocalCluster


def main() -> None:
    """Be a cluster with one worker of two threads."""
    with LocalCluster(
        n_workers=1, threads_per_worker=2, processes=False, dashboard_address=None, protocol="tcp"
    ) as cluster:
        print(cluster.scheduler_address, flush=True)
        sys.stdin.read()


if __name__ == "__main__":
    main()
