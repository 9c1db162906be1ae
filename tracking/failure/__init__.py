"""Which body parts a tracker has lost: features, samples, the detector, its training."""

from tracking.failure.detector import FALSE_ALARMS, Detector, Judgement, Origin
from tracking.failure.detector_file import built_in_detector, load_detector, save_detector
from tracking.failure.features import FEATURE_NAMES, FEATURE_SPAN_S, STATE_NAMES, part_features
from tracking.failure.labelled import part_states, samples_of
from tracking.failure.machines import Machine, Machines
from tracking.failure.operating import Curve
from tracking.failure.past import PastStates, states_before
from tracking.failure.preparation import Preparation
from tracking.failure.samples import (
    SAMPLE_COLUMNS,
    SAMPLE_SOURCES,
    Samples,
    joined,
    no_samples,
)
from tracking.failure.training import Trained, TrainingPlan, TrainingReport, train

__all__ = [
    "FALSE_ALARMS",
    "FEATURE_NAMES",
    "FEATURE_SPAN_S",
    "SAMPLE_COLUMNS",
    "SAMPLE_SOURCES",
    "STATE_NAMES",
    "Curve",
    "Detector",
    "Judgement",
    "Machine",
    "Machines",
    "Origin",
    "PastStates",
    "Preparation",
    "Samples",
    "Trained",
    "TrainingPlan",
    "TrainingReport",
    "built_in_detector",
    "joined",
    "load_detector",
    "no_samples",
    "part_features",
    "part_states",
    "samples_of",
    "save_detector",
    "states_before",
    "train",
]
