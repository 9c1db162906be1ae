"""Look detector files over before their data is touched: `python inspection.py FILE...`.

See `tracking.untrusted.program` for why this is a program of its own, and what it prints.
"""

from __future__ import annotations

from pathlib import Path

from tracking.untrusted import (
    Kind,
    Refused,
    bare_packages,
    checked_file,
    say_verdicts,
)

if __name__ == "__main__":
    bare_packages("failure", "tracks")

from tracking.failure.detector_layout import FORMAT, MACHINES, MOST_BYTES, VERSION
from tracking.tracks.body_parts import PART_NAMES

_KIND = Kind("detector", FORMAT, VERSION, MOST_BYTES, dimensions=2)


def inspect(path: Path) -> tuple[int, int]:
    """The file's format version. Raises Refused where it is not a detector safe to read."""
    with checked_file(path, _KIND) as (file, version, datasets):
        several = MACHINES[-1] in file.get("machines", ())
        for name, dimensions, kind in _expected(several):
            dataset = datasets.get(name)
            if dataset is None:
                raise Refused("has no array {name}; {choose}", name=name, choose=_KIND.choose)
            if dataset.ndim != dimensions or dataset.dtype.kind != kind:
                raise Refused(
                    "has {dtype} in {ndim} dimensions at {name}",
                    dtype=dataset.dtype,
                    ndim=dataset.ndim,
                    name=name,
                )
        datasets["origin/recordings"].asstr(errors="replace")[()]
    return version


def _expected(several: bool) -> list[tuple[str, int, str]]:
    """Path, dimensions and kind of number of each array."""
    machines = MACHINES if several else PART_NAMES
    return [
        *(("preparation/centre", 1, "f"), ("preparation/scale", 1, "f")),
        *((f"machines/{name}/support", 2, "f") for name in machines),
        *((f"machines/{name}/coefficient", 1, "f") for name in machines),
        *((f"operating/{name}/{side}", 1, "f") for name in machines for side in ("on", "off")),
        *(("origin/counts", 2, "i"), ("origin/instants", 1, "i"), ("origin/recordings", 1, "O")),
    ]


if __name__ == "__main__":
    say_verdicts(inspect)
