"""The list of parts that are worth labelling."""

from app.core.scenes.labels import SuggestedPart, Tool
from app.features.labelling.scene import LabellingScene
from app.features.labelling.suggestions import SuggestionsList

NARROW_LETTERS = 34


def test_its_title_wraps_so_that_nothing_is_cut_in_a_narrow_window(qtbot, dark):
    found = tuple(
        SuggestedPart((at, 2, 0), "unsure", "head", "2", (200, 80, 40), "00:09.35")
        for at in range(156)
    )
    shown = SuggestionsList()
    qtbot.addWidget(shown)
    shown.show_scene(LabellingScene(Tool.PARTS, "", "", suggestions=found))
    letter = shown.fontMetrics().averageCharWidth()
    assert shown.minimumSizeHint().width() <= NARROW_LETTERS * letter
