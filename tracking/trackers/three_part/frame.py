"""One frame as the tracker of parts looks at it."""

from __future__ import annotations

from tracking.people import Detections, Observation
from tracking.people.appearance_source import Embeddings
from tracking.people.parts import ycbcr
from tracking.trackers.three_part.bodies import outlined_boxes
from tracking.trackers.three_part.claims import Claims, associate_detections, claims_of
from tracking.trackers.three_part.people import Floats, PartPeople


class Frame:
    """What is seen in a frame, and whose it is.

    Attributes:
        seen: the regions. picture: (height, width, 3) of `ycbcr`.
        embeddings: (regions, d) of an appearance network; None: there is none.
        time_s: since the recording began. elapsed_s: since the frame before; 0 in the first.
    """

    def __init__(self, observation: Observation, elapsed_s: float) -> None:
        """Look at an observation, so long after the one before."""
        assert observation.picture is not None, "perception of one camera hands the picture on"
        self.seen: Detections = observation.people
        self.picture = ycbcr(observation.picture)
        self.embeddings: Embeddings | None = None
        if observation.embed is not None:
            self.embeddings = observation.embed(self.seen.box)
        self.time_s = observation.time_s
        self.elapsed_s = elapsed_s
        self._claims: tuple[Floats, Claims] | None = None

    def claims(self, people: PartPeople) -> Claims:
        """Which regions are whose; worked out anew only where parts stand elsewhere than before.

        The columns of `PartPeople` are never changed in place: the same array is the same places.
        """
        if self._claims is None or self._claims[0] is not people.state:
            claims = claims_of(people.rectangles, self.seen)
            # One rectangle alone lies too far within its body to be compared with boxes.
            if self.seen.from_detector.any() and people.rectangles.shape[1] > 1:
                boxes = outlined_boxes(people.rectangles, people.outline)
                claims = associate_detections(claims, boxes, self.seen)
            self._claims = people.state, claims
        return self._claims[1]
