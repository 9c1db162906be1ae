"""The queue: decided suspicions leave it, in whatever order it is walked."""

from __future__ import annotations

import pytest

from tracking.review import Suspicion, open_suspicions, ranked
from tracking.tracks import Labels, ReviewedRange, Verdict

FPS = 20.0


def suspicion(
    kind: str = "turn", tracks: tuple[int, ...] = (1, 2), frame: int = 100, **more: object
) -> Suspicion:
    values = {"likelihood": 0.5, "cost": 10.0, "text": "why", "fix": "swap", **more}
    return Suspicion(kind, tracks, frame, frame - 5, frame + 5, **values)


def labels(*verdicts: Verdict, reviewed: tuple[ReviewedRange, ...] = ()) -> Labels:
    return Labels(verdicts={one.key: one for one in verdicts}, reviewed=reviewed)


@pytest.mark.parametrize("decision", ["right", "fixed", "dismissed"])
def test_a_decided_suspicion_leaves_the_queue(decision: str) -> None:
    left = open_suspicions([suspicion()], labels(Verdict("turn", (1, 2), 100, decision)), FPS)
    assert left == ()


@pytest.mark.parametrize(("frame", "stays"), [(110, False), (120, False), (121, True), (60, True)])
def test_a_verdict_stays_with_what_is_found_again_within_a_second(frame: int, stays: bool) -> None:
    decided = labels(Verdict("turn", (1, 2), 100, "right"))
    assert bool(open_suspicions([suspicion(frame=frame)], decided, FPS)) == stays


def test_a_verdict_says_nothing_of_other_kinds_and_tracks() -> None:
    others = (suspicion(kind="lost"), suspicion(tracks=(1, 3)))
    assert open_suspicions(others, labels(Verdict("turn", (1, 2), 100, "right")), FPS) == others


def test_all_tracks_must_have_been_reviewed_at_that_frame() -> None:
    one = labels(reviewed=(ReviewedRange(1, 0, 200),))
    both = labels(reviewed=(ReviewedRange(1, 0, 200), ReviewedRange(2, 90, 101)))
    everybody = labels(reviewed=(ReviewedRange(0, 100, 101),))
    assert len(open_suspicions([suspicion()], one, FPS)) == 1
    assert open_suspicions([suspicion()], both, FPS) == ()
    assert open_suspicions([suspicion()], everybody, FPS) == ()


def test_without_labels_everything_is_open() -> None:
    assert open_suspicions([suspicion()], None, FPS) == (suspicion(),)


def test_the_order_is_by_worth_by_likelihood_or_by_time() -> None:
    cheap = suspicion(frame=1, likelihood=0.9, cost=1.0)
    dear = suspicion(frame=3, likelihood=0.2, cost=100.0)
    middling = suspicion(frame=2, likelihood=0.5, cost=10.0)
    suspicions = [cheap, middling, dear]
    assert ranked(suspicions) == (dear, middling, cheap)
    assert ranked(suspicions, "likelihood") == (cheap, middling, dear)
    assert ranked(reversed(suspicions), "time") == (cheap, middling, dear)
