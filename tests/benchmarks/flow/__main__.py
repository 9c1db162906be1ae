"""Flow: `python -m tests.benchmarks.flow [--report] [--only SECTION ...]`."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tests.benchmarks.clips import Clip
from tests.benchmarks.flow.counts import STRETCH_S, count_scenes
from tests.benchmarks.pages import Figures, Page
from tracking.counting import PAPER_STEP_S
from tracking.pages import Panel, svg

SCENES = ("lane", "two-way")
TUNED = tuple(Clip(scene, 5101) for scene in SCENES)
"""For choosing settings; never reported."""
REPORTED = tuple(Clip(scene, seed) for scene in SCENES for seed in (5201, 5202))
"""Nothing was chosen on these."""


def counts_picture(rows: Sequence[Figures]) -> str:
    """The paper's figure 10: people in the region over time, true and counted, as SVG."""
    panels = []
    for row in rows:
        if row["tracker"] != "flow":
            continue
        true, ours = np.array(row["true_steps"], float), np.array(row["steps"], float)
        x = PAPER_STEP_S * np.arange(len(true))
        top = max(float(true.max(initial=1.0)), float(ours.max(initial=1.0))) + 1.0
        curves = {"true": true, "counted": ours}
        title = f"{row['scene']} {row['seed']}"
        axes = ("seconds", "people in the region")
        panels.append(Panel(title, curves, x, axes, (0.0, float(x[-1])), (0.0, top)))
    return svg(panels)


PAGE = Page(
    subject="flow",
    about=__doc__ or "",
    measures={
        "scenes": lambda report: count_scenes(REPORTED if report else TUNED),
    },
    words={
        "paper": (("lane", 963, 1057), ("two-way", 865, 801)),  # [Yoneji2013] table 2
        "stretch_s": STRETCH_S,
    },
    diagrams={"scenes": ("counts", counts_picture)},
)

if __name__ == "__main__":
    PAGE.main()
