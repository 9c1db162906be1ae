"""Training the failure detector: which labels, with which settings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from app.core.i18n import joined, joined_text, tr
from app.core.scenes.part_names import part_name
from tracking.failure import (
    FALSE_ALARMS,
    Samples,
    Trained,
    TrainingPlan,
    built_in_detector,
    train,
)
from tracking.failure.training.questions import LEAST_PEOPLE, LEAST_SAMPLES
from tracking.setting import setting
from tracking.tracks import PART_NAMES

Report = Callable[[int, int], None]
_PLAN = TrainingPlan()


@dataclass(frozen=True, slots=True)
class TrainingSettings:
    """What the user can say of the training."""

    false_alarms: float = setting(
        FALSE_ALARMS,
        "",
        (0.0, 0.5),
        "Highest false alarm rate: share of correct parts that are called failed; higher: more "
        "failures are found",
    )
    folds: int = setting(
        _PLAN.folds,
        "",
        (2, 20),
        "Folds of the cross-validation, split by person; higher: more certain figures, more time",
    )
    search_samples: int = setting(
        _PLAN.searched,
        "",
        (100, 20000),
        "Most samples of a part in the search for parameters; higher: more time",
    )
    training_samples: int = setting(
        _PLAN.learnt,
        "",
        (100, 50000),
        "Most samples of a part that the detector is trained on; higher: more time",
    )
    from_scratch: bool = setting(
        False,
        "",
        None,
        "Keep nothing of the built-in detector. Off: its machines are mixed with what these labels "
        "teach, as far as people held out are judged better",
    )
    seed: int = setting(
        0, "", (0, 999_999), "Seed of the random numbers; the same seed gives the same detector"
    )

    def plan(self) -> TrainingPlan:
        """As training takes them."""
        return replace(
            _PLAN,
            false_alarms=self.false_alarms,
            folds=self.folds,
            searched=self.search_samples,
            learnt=self.training_samples,
            adapt=None if self.from_scratch else built_in_detector,
        )


@dataclass(frozen=True, slots=True)
class SettingsOfTraining:
    """What a form is made from."""

    settings_type: type = TrainingSettings


@dataclass(frozen=True, slots=True)
class PartCount:
    """How many samples of a part there are, and of how many people.

    Attributes:
        missing: why it is too few to train; "" where it is enough.
    """

    name: str
    on: int
    off: int
    people_on: int
    people_off: int
    missing: str


def counts_of(samples: Samples) -> tuple[PartCount, ...]:
    """The samples of each part."""
    people = samples.people() if len(samples) else np.zeros(0, np.int64)
    part, label = samples.columns["part"], samples.columns["label"]
    counts = []
    for number in range(len(PART_NAMES)):
        rows = [(part == number) & (label == answer) for answer in (1, 0)]
        on, off = (int(one.sum()) for one in rows)
        people_on, people_off = (len(np.unique(people[one])) for one in rows)
        said = _missing(on, off, people_on, people_off)
        counts.append(PartCount(part_name(number), on, off, people_on, people_off, said))
    return tuple(counts)


def _missing(on: int, off: int, people_on: int, people_off: int) -> str:
    """Everything that is missing, of both answers, so that nothing comes up only later."""
    sides = ((on, people_on, tr("on")), (off, people_off, tr("off")))
    more = [
        tr("{n} more {which}", n=LEAST_SAMPLES - samples, which=which)
        for samples, _, which in sides
        if samples < LEAST_SAMPLES
    ]
    few = [which for _, people, which in sides if people < LEAST_PEOPLE]
    said = [tr("label {more}", more=joined(" and ", more))] if more else []
    if few:
        who = joined(" and ", few)
        said.append(tr("{who}: of {n} people or more", who=who, n=LEAST_PEOPLE))
    return joined_text("; ", said)


def train_on(samples: Samples, settings: TrainingSettings, report: Report) -> Trained:
    """Train; `report` raises where the user has cancelled."""
    random = np.random.default_rng(settings.seed)
    return train(samples, settings.plan(), random=random, progress=report)
