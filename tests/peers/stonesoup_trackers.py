"""Stone Soup's trackers over detections, for `follow.py`.

Constant velocity on the floor, a Kalman filter, tracks confirmed after so many measurements and
deleted after so long without one or when their place is too unsure: put together as in its
tutorials on data association and initiators.
"""

from datetime import datetime, timedelta

import numpy as np
from stonesoup.dataassociator.neighbour import GNNWith2DAssignment
from stonesoup.dataassociator.probability import JPDAwithEHM2
from stonesoup.deleter.error import CovarianceBasedDeleter
from stonesoup.deleter.multi import CompositeDeleter
from stonesoup.deleter.time import UpdateTimeDeleter
from stonesoup.hypothesiser.distance import DistanceHypothesiser
from stonesoup.hypothesiser.probability import PDAHypothesiser
from stonesoup.initiator.simple import MultiMeasurementInitiator
from stonesoup.measures import Mahalanobis
from stonesoup.models.measurement.linear import LinearGaussian
from stonesoup.models.transition.linear import (
    CombinedLinearGaussianTransitionModel,
    ConstantVelocity,
)
from stonesoup.predictor.kalman import KalmanPredictor
from stonesoup.tracker.simple import MultiTargetMixtureTracker, MultiTargetTracker
from stonesoup.types.detection import Detection
from stonesoup.types.state import GaussianState
from stonesoup.types.update import Update
from stonesoup.updater.kalman import KalmanUpdater

START = datetime(2000, 1, 1)
PLACE = (0, 2)
"""Where x and y stand in the state, each followed by its velocity."""


def deleter(settings, after_s):
    """Of tracks without a measurement for so long, or known to worse than so many metres."""
    return CompositeDeleter(
        [
            UpdateTimeDeleter(timedelta(seconds=after_s)),
            CovarianceBasedDeleter(2 * settings["unsure_m"] ** 2, mapping=list(PLACE)),
        ],
        intersect=False,
    )


def parts(settings):
    """Predictor, updater, measurement model and the associator by least total distance."""
    drift = [ConstantVelocity(settings["drift"]), ConstantVelocity(settings["drift"])]
    model = LinearGaussian(4, PLACE, np.diag([settings["noise_m"] ** 2] * 2))
    predictor = KalmanPredictor(CombinedLinearGaussianTransitionModel(drift))
    updater = KalmanUpdater(model)
    by_distance = DistanceHypothesiser(
        predictor, updater, Mahalanobis(), missed_distance=settings["gate"]
    )
    return predictor, updater, model, GNNWith2DAssignment(by_distance)


def initiator(settings, updater, model, nearest):
    """Holds tracks back until they have been measured often enough."""
    speed = settings["speed_m_s"] ** 2
    return MultiMeasurementInitiator(
        prior_state=GaussianState([[0], [0], [0], [0]], np.diag([0, speed, 0, speed])),
        measurement_model=model,
        deleter=deleter(settings, settings["held_s"]),
        data_associator=nearest,
        updater=updater,
        min_points=settings["min_points"],
    )


def steps(tracker, settings, fps):
    """The step of a tracker."""

    def step(frame, seen):
        time = START + timedelta(seconds=frame / fps)
        given = {Detection(place[:, None], timestamp=time) for place in seen[:, 5:7]}
        _, tracks = tracker.update_tracker(time, given)
        for track in sorted(tracks, key=lambda one: one.id):
            last = next(s.timestamp for s in reversed(track.states) if isinstance(s, Update))
            if (time - last).total_seconds() <= settings["told_s"] + 1e-6:
                yield track.id, track.state_vector[PLACE, 0]

    return step


def gnn(settings, fps):
    """Global nearest neighbour."""
    _, updater, model, nearest = parts(settings)
    tracker = MultiTargetTracker(
        initiator=initiator(settings, updater, model, nearest),
        deleter=deleter(settings, settings["lost_s"]),
        detector=None,
        data_associator=nearest,
        updater=updater,
    )
    return steps(tracker, settings, fps)


def jpda(settings, fps):
    """Joint probabilistic data association, by its efficient hypothesis management."""
    predictor, updater, model, nearest = parts(settings)
    hypothesiser = PDAHypothesiser(
        predictor,
        updater,
        clutter_spatial_density=settings["clutter_per_m2"],
        prob_detect=settings["detected"],
        prob_gate=settings["inside_gate"],
    )
    tracker = MultiTargetMixtureTracker(
        initiator=initiator(settings, updater, model, nearest),
        deleter=deleter(settings, settings["lost_s"]),
        detector=None,
        data_associator=JPDAwithEHM2(hypothesiser),
        updater=updater,
    )
    return steps(tracker, settings, fps)
