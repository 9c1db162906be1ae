"""From samples to a detector: folds by person, grid search, operating points, report."""

from tracking.failure.training.detector_trainer import Trained, TrainingPlan, train
from tracking.failure.training.page import check_training_folder, page_of, write_report
from tracking.failure.training.report import Mistake, QuestionReport, TrainingReport
from tracking.failure.training.svm_fit import GRID, Candidate
