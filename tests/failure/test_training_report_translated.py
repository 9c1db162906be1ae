"""A training report is in the user's language: no word of it stays English."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from made_up_parts import made_up_samples

from tests.page_reader import WORD, Portuguese, Reader, english
from tracking.failure import TrainingPlan, train
from tracking.failure.training import Candidate, TrainingReport, page_of
from tracking.translation import use_catalogue


@pytest.fixture(scope="module")
def trained() -> TrainingReport:
    plan = TrainingPlan(grid=(Candidate(1.0, 0.3),), folds=3, searched=200)
    return train(made_up_samples(1, people=9), plan, random=np.random.default_rng(7)).report


@pytest.fixture(autouse=True)
def wide() -> Iterator[None]:
    use_catalogue(Portuguese())
    yield
    use_catalogue(None)


def test_no_word_of_a_training_report_stays_english(trained: TrainingReport) -> None:
    shown = {each.sample: b"picture" for each in trained.questions[0].mistakes[:1]}
    origin = trained.detector.origin
    chosen = [question.candidate for question in trained.questions]
    names = (*origin.recordings, origin.software, trained.detector.fingerprint, *chosen)
    data = set(WORD.findall(" ".join(names)))
    assert english(Reader(page_of(trained, shown)).said, data) == set()
