"""What edits and their choices are called."""

from __future__ import annotations

from app.core.editing.edit_options import EditScope, Fill, LongestGap, Option, Way
from app.core.editing.flow import EditFlow
from app.core.i18n import tr


def question(option: Option) -> str:
    """What is chosen with an option."""
    if isinstance(option, EditScope):
        return tr("Scope")
    if isinstance(option, Fill):
        return tr("Frames of neither")
    if isinstance(option, LongestGap):
        return tr("Gaps of up to")
    of_merge = option in (Way.KEEP_FIRST, Way.KEEP_SECOND, Way.KEEP_SURER)
    return tr("Frames of both") if of_merge else tr("Path in the gap")


def option_name(option: Option, flow: EditFlow) -> str:
    """One of the things that can be chosen between."""
    if isinstance(option, EditScope):
        return _scope_name(option)
    if isinstance(option, LongestGap):
        return _length_name(option)
    others = flow.also or (flow.other,)
    second = str(others[0]) if len(others) == 1 and others[0] else tr("the other")
    names: dict[Way | Fill, str] = {
        Way.KEEP_FIRST: tr("keep {track}", track=flow.track),
        Way.KEEP_SECOND: tr("keep {track}", track=second),
        Way.KEEP_SURER: tr("keep the more certain one"),
        Way.LINEAR: tr("straight in the image"),
        Way.FLOOR: tr("evenly along the floor"),
        Fill.LEAVE: tr("leave gaps open"),
        Fill.FILL: tr("fill between them"),
    }
    return names[option]


def _scope_name(scope: EditScope) -> str:
    names = {
        EditScope.ON: tr("from here on"),
        EditScope.RANGE: tr("this range"),
        EditScope.FRAME: tr("this frame"),
        EditScope.WHOLE: tr("the whole track"),
        EditScope.BETWEEN: tr("between the keyframes"),
        EditScope.GAP: tr("this gap"),
        EditScope.JOINED: tr("and the gap beside it"),
    }
    return names[scope]


def _length_name(longest: LongestGap) -> str:
    names = {
        LongestGap.SHORT: tr("half a second"),
        LongestGap.SECOND: tr("a second"),
        LongestGap.SECONDS: tr("3 seconds"),
        LongestGap.LONG: tr("10 seconds"),
        LongestGap.ANY: tr("any length"),
    }
    return names[longest]
