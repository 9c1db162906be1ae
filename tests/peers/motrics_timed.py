"""motrics' time and memory: `motrics_timed.py SEQUENCES`, in its own environment.

From boxes in memory by frame, in the form that it need not copy: everything it measures at once.
"""

import json
import sys
import time

import motrics
import numpy as np
from peaks import forget_peak, peak_kib
from sequences import by_frame, read_sequences


def side(rows, frames):
    """A side by frame, boxes as corners counted from pixel 1."""
    parts = by_frame(rows, frames)
    low = [part[:, 2:4] + 1.0 for part in parts]
    corners = [np.hstack([at, at + part[:, 4:6]]) for at, part in zip(low, parts, strict=True)]
    return motrics.Frames([part[:, 1].astype(int).tolist() for part in parts], corners)


def main():
    """Print the time, the peak of memory and three figures."""
    ((truth, result),) = read_sequences(sys.argv[1]).values()
    frames = 1 + int(max(truth[-1, 0], result[-1, 0]))
    people, tracks = side(truth, frames), side(result, frames)
    del truth, result
    forget_peak()
    begun = time.process_time()
    found = motrics.evaluate(people, tracks)
    taken = time.process_time() - begun
    peak = peak_kib()
    figures = {"MOTA": found.clear.mota, "IDF1": found.identity.idf1, "HOTA": found.hota.hota}
    print(json.dumps({"seconds": taken, "peak_kib": peak} | figures))


if __name__ == "__main__":
    main()
