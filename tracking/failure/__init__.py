"""Which body parts a tracker has lost: features, samples, the detector, its training."""

from tracking.failure.core.detector import FALSE_ALARMS, Detector, Judgement, Origin
from tracking.failure.core.features import FEATURE_NAMES, FEATURE_SPAN_S, STATE_NAMES, part_features
from tracking.failure.core.machines import Machine, Machines
from tracking.failure.core.operating_points import Curve
from tracking.failure.core.preparation import Preparation
from tracking.failure.core.samples import (
    BESIDES,
    SAMPLE_COLUMNS,
    SAMPLE_SOURCES,
    Samples,
    joined,
    no_samples,
)
from tracking.failure.detector_file import built_in_detector, load_detector, save_detector
from tracking.failure.label_suggestions import Suggestion, suggest
from tracking.failure.labelled_samples import part_states, samples_of
from tracking.failure.past import PastStates, states_before
from tracking.failure.recordings import told_apart
from tracking.failure.training import (
    Mistake,
    QuestionReport,
    Trained,
    TrainingPlan,
    TrainingReport,
    check_training_folder,
    train,
    write_report,
)
from tracking.failure.true_labels import labels_from_truth, people_followed
