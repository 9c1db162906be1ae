"""Frozen scenes: everything a view needs to draw one frame, and nothing else.

Presenters make scenes, views draw them. No Qt here; colours are (red, green, blue) 0..255.
"""

from app.core.scenes.frame_scenes import (
    Colour,
    FloorPerson,
    LegendEntry,
    OverheadScene,
    PersonMark,
    PictureScene,
    Points,
    PreviewTrail,
    Side,
)
from app.core.scenes.lists import CommandItem, RecentItem, WelcomeScene
from app.core.scenes.side_panels import ChoiceRow, EditPreview, HistoryItem, Proposal, TrackCard
from app.core.scenes.timelines import (
    Lane,
    MarkKind,
    SpanKind,
    TimelineMark,
    TimelineScene,
    TransportScene,
)

__all__ = [
    "ChoiceRow",
    "Colour",
    "CommandItem",
    "EditPreview",
    "FloorPerson",
    "HistoryItem",
    "Lane",
    "LegendEntry",
    "MarkKind",
    "OverheadScene",
    "PersonMark",
    "PictureScene",
    "Points",
    "PreviewTrail",
    "Proposal",
    "RecentItem",
    "Side",
    "SpanKind",
    "TimelineMark",
    "TimelineScene",
    "TrackCard",
    "TransportScene",
    "WelcomeScene",
]
