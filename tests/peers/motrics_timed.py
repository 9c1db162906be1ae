"""motrics' time and memory, in its own environment; see `timed.print_timed`.

From boxes in memory by frame, in the form that it need not copy: everything it measures at once.
"""

import motrics
import numpy as np
from sequences import by_frame
from timed import print_timed


def side(rows, frames):
    """A side by frame, boxes as corners counted from pixel 1."""
    parts = by_frame(rows, frames)
    low = [part[:, 2:4] + 1.0 for part in parts]
    corners = [np.hstack([at, at + part[:, 4:6]]) for at, part in zip(low, parts, strict=True)]
    return motrics.Frames([part[:, 1].astype(int).tolist() for part in parts], corners)


def prepare(truth, result):
    """Both sides."""
    frames = 1 + int(max(truth[-1, 0], result[-1, 0]))
    people, tracks = side(truth, frames), side(result, frames)

    def measure():
        found = motrics.evaluate(people, tracks)
        return found.clear.mota, found.identity.idf1, found.hota.hota

    return measure


if __name__ == "__main__":
    print_timed(prepare)
