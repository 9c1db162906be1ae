"""A job script for SLURM: a batch as an array of shards, and a last job that puts them together."""

from __future__ import annotations

import shlex
from collections.abc import Sequence


def array_script(words: Sequence[str], count: int, minutes: int, memory_mb: int) -> str:
    """The script; `sbatch` takes it.

    Args:
        words: the command without --shard. count: how many shards.
        minutes, memory_mb: what each may take.
    """
    command = shlex.join(words)
    return f"""#!/bin/bash
#SBATCH --job-name=trackwright
#SBATCH --array=1-{count}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time={minutes}
#SBATCH --mem={memory_mb}M
#SBATCH --signal=B:TERM@60
#SBATCH --output=trackwright-%A-%a.log

# Send it with: sbatch SCRIPT. Sent again after whatever happened, it does what is left.
# The last job puts the shards' ledgers together and writes the report.
if [ -z "$SLURM_ARRAY_TASK_ID" ]; then
  exec {command}
fi
if [ "$SLURM_ARRAY_TASK_ID" = 1 ]; then
  sbatch --job-name=trackwright-report --dependency=afterany:"$SLURM_ARRAY_JOB_ID" \\
    --ntasks=1 --cpus-per-task=1 --time={minutes} --mem={memory_mb}M --wrap {shlex.quote(command)}
fi
{command} --workers 1 --shard "$SLURM_ARRAY_TASK_ID/{count}" &
trap 'kill -TERM $!' TERM
wait $!
status=$?
while kill -0 $! 2>/dev/null; do wait $!; status=$?; done
exit $status
"""
