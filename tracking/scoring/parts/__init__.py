"""Accuracy of tracked body parts against exact truth, by the measure of [ZhaoLee2009]."""

from tracking.scoring.parts.part_truth import read_part_truth
from tracking.scoring.parts.part_verdicts import Judged, judge
from tracking.scoring.parts.rates import LAST_FRAME, SUBJECTS, Rates, margin, rates_of
from tracking.scoring.parts.rectangles import bounding
from tracking.scoring.parts.rows import (
    PartTruth,
    TrackedParts,
    by_person,
    tracked_parts,
    tracked_people,
)
