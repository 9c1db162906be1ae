"""What formats keep of how much of a person is seen."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_tracks import table, through
from numpy.testing import assert_allclose

from tracking.formats import FORMATS
from tracking.formats.track_writer import Exported
from tracking.tracks import TrackTable

SEEN = [np.nan, 0.0, 0.04, 0.1, 0.3, 0.31, 0.49, 0.5, 0.51, 0.75, 0.76, 1.0]


@pytest.mark.parametrize("name", ["mot16", "kitti", "csv", "cvat"])
def test_a_format_tells_what_it_keeps_of_visibility(tmp_path: Path, name: str) -> None:
    places = [(frame, 1) for frame in range(2 * len(SEEN))]
    boxes = [(5.0 * frame, 5.0, 20.0, 40.0) for frame, _ in places]
    rows = table(places, boxes, visibility=SEEN * 2).columns()
    rows = {**rows, "predicted": np.repeat([False, True], len(SEEN))}
    found = through(FORMATS[name], tmp_path / "t", Exported(rows, TrackTable(rows), len(places)))
    kept = rows["visibility"]
    if found.seen_as is not None:
        kept = found.seen_as(kept, rows["predicted"])
    assert_allclose(found.columns["visibility"], kept, atol=1e-6)
