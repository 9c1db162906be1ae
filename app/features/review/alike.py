"""Deciding many review items at once: which are like the one that is looked at."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.core.i18n import tr
from app.features.review.presenter import kind_title
from tracking.editing import Change, plan_verdicts
from tracking.review import ReviewItem
from tracking.tracks import Labels, Verdict
from tracking.translation import count_msg


@dataclass(frozen=True, slots=True)
class AlikeGroup:
    """Review items that can be decided together, the one that is looked at among them.

    Attributes:
        title: what they share, in words. items: in the queue's order.
    """

    title: str
    items: tuple[ReviewItem, ...]


def groups_alike(
    current: ReviewItem, left: Sequence[ReviewItem], name_of: Callable[[int], str]
) -> tuple[AlikeGroup, ...]:
    """The groups a decision may go for; those of one item alone are left out.

    Args:
        left: the review items that are not decided, in the queue's order.
        name_of: a track's number and name.
    """
    chance, kind = current.likelihood, kind_title(current.kind)
    less = tr("{chance:.0%} likely or less to be errors", chance=chance)
    wanted: list[tuple[str, Callable[[ReviewItem], bool]]] = [
        (tr("All of this kind: {kind}", kind=kind), lambda one: one.kind == current.kind),
        (
            tr("All of this kind that are {less}", less=less),
            lambda one: one.kind == current.kind and one.likelihood <= chance,
        ),
        *((tr("All of {who}", who=name_of(track)), _about(track)) for track in current.tracks),
        (tr("All that are {less}", less=less), lambda one: one.likelihood <= chance),
    ]
    groups = (AlikeGroup(title, tuple(filter(test, left))) for title, test in wanted)
    return tuple(group for group in groups if len(group.items) > 1)


def _about(track: int) -> Callable[[ReviewItem], bool]:
    return lambda one: track in one.tracks


def plan_decisions(items: Sequence[ReviewItem], decision: str, labels: Labels) -> Change:
    """The change that keeps one decision on many review items: undone as one.

    Raises:
        EditError: all of that was said already.
    """
    verdicts = [Verdict(one.kind, one.tracks, one.frame, decision) for one in items]
    what = count_msg(len(verdicts), "{n} review item", "{n} review items")
    return plan_verdicts(labels, verdicts, what)
