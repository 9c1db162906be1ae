"""One frame as the tracker of parts looks at it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracking.people import Detections, Observation
from tracking.people.appearance_source import Embeddings
from tracking.people.parts import ycbcr
from tracking.trackers.three_part.appearance import Levels, measure_levels
from tracking.trackers.three_part.bodies import outlined_boxes
from tracking.trackers.three_part.claims import Claims, associate_detections, claims_of
from tracking.trackers.three_part.initiation import regions_rectangles
from tracking.trackers.three_part.people import Floats, Layout, PartPeople
from tracking.trackers.three_part.reidentification import resemblances

_THREE = Layout(parts=3, together=1)


class Frame:
    """What is seen in a frame, and whose it is.

    Attributes:
        seen: the regions. picture: (height, width, 3) of `ycbcr`.
        bodies: each region is of one body, with the box of all of it.
        embeddings: (regions, d) of an appearance network; None: there is none.
        time_s: since the recording began. elapsed_s: since the frame before; 0 in the first.
    """

    def __init__(self, observation: Observation, elapsed_s: float, *, bodies: bool) -> None:
        """Look at an observation, so long after the one before.

        Args:
            bodies: regions are of one body each, with the box of all of it, as those of a
                detector are: so perception has them where the floor tells how large people are.
        """
        assert observation.picture is not None, "perception of one camera hands the picture on"
        self.seen: Detections = observation.people
        if bodies:
            given = self.seen.from_detector | ~self.seen.merged
            self.seen = replace(self.seen, from_detector=given)
        self.picture = ycbcr(observation.picture)
        self.bodies = bodies
        self.embeddings: Embeddings | None = None
        if observation.embed is not None:
            self.embeddings = observation.embed(self.seen.box)
        self.time_s = observation.time_s
        self.elapsed_s = elapsed_s
        self._claims: tuple[Floats, Claims] | None = None
        self._look: Levels | None = None

    def claims(self, people: PartPeople) -> Claims:
        """Which regions are whose; worked out anew only where parts stand elsewhere than before.

        The columns of `PartPeople` are never changed in place: the same array is the same places.
        """
        if self._claims is None or self._claims[0] is not people.state:
            claims = claims_of(people.rectangles, self.seen)
            # One rectangle alone lies too far within its body to be compared with boxes.
            if self.seen.from_detector.any() and people.rectangles.shape[1] > 1:
                boxes = outlined_boxes(people.rectangles, people.outline)
                alike = resemblances(self._looks(), people.appearance) if self.bodies else None
                claims = associate_detections(claims, boxes, self.seen, alike)
            self._claims = people.state, claims
        return self._claims[1]

    def _looks(self) -> Levels:
        """(regions, 3, 3, 256) the colours of the parts of who is in each region."""
        if self._look is None:
            rows = np.arange(len(self.seen))
            parts = regions_rectangles(self.seen, rows, self.picture, _THREE)
            self._look = measure_levels(self.picture, np.nan_to_num(parts))
        return self._look
