"""Counting people: passages over lines, people inside regions, density and speed in time."""

from tracking.counting.comparison import LATEST_S, Hits, compare_passages
from tracking.counting.counts import (
    Counts,
    CountSettings,
    LineCount,
    NotOnFloorError,
    check_countable,
    count,
)
from tracking.counting.flow_map import CELL_M, FlowMap, flow_map
from tracking.counting.occupancy import Occupancy, density_of, occupancy
from tracking.counting.passages import Passages, passages, passages_of_line
from tracking.counting.paths import Paths
from tracking.counting.polygons import area, inside
from tracking.counting.speeds import WINDOW_S, half_window, lengths, velocities
from tracking.counting.steps import PAPER_STEP_S, Steps
from tracking.counting.table import HEADINGS, number_as_text, rows_of, write_counts
from tracking.tracks.labels import CountingLine, Region
