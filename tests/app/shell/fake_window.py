"""A window as commands see it, without a window."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from app.core.commands import CommandRegistry
from app.core.editing.annotation_mode import AnnotationMode
from app.core.tracks.frame_state import ViewOptions
from app.features.correction.attribute_controller import AttributeController
from app.features.labelling.controller import LabelController
from app.features.parts.controller import PartsController
from app.features.review.controller import ReviewController
from app.features.scoring.controller import ScoreController
from app.shell.commands import COMMANDS


def window_app(**given: Any) -> Any:
    """A window as commands see it; without words a recording with tracks and a session is open."""
    now = {"session": True, "tracks": True, "stereo": True, "in_the_way": "", "further": False}
    now = {
        **now,
        "truth": False,
        "selected": False,
        "read_only": False,
        "elsewhere": False,
        **given,
    }
    history = SimpleNamespace(next_undo=None, next_redo=None)
    document = SimpleNamespace(
        session=SimpleNamespace(read_only=now["read_only"], history=history)
        if now["session"]
        else None,
        tracks=SimpleNamespace(ids=(1,) if now["tracks"] else ()),
        selection=bool(now["selected"]),
        flow=None,
        correcting=SimpleNamespace(mode=AnnotationMode(), marked=None),
        in_the_way=now["in_the_way"],
        shows_further_run=now["further"],
        recording=SimpleNamespace(
            is_stereo=now["stereo"], view=object(), truth_path="truth.txt" if now["truth"] else None
        ),
    )
    parts = SimpleNamespace(
        any_tracked=False, tracked_elsewhere=now["elsewhere"], truth_known=False
    )
    reviewing = SimpleNamespace(
        lists_items=False,
        current=None,
        fixable=False,
        waits=False,
        plays=False,
        measures=False,
        watching=SimpleNamespace(stretch=(0, 0)),
        flags_hand_made=False,
        queue=SimpleNamespace(open=()),
    )
    controllers: dict[type, Any] = {
        PartsController: SimpleNamespace(presenter=parts),
        ScoreController: SimpleNamespace(known=False),
        LabelController: SimpleNamespace(tool=None, suggests=False),
        ReviewController: reviewing,
        AttributeController: SimpleNamespace(schema=(), active=None),
    }
    batches = SimpleNamespace(watched=None)
    projects = SimpleNamespace(
        is_open=False, is_batch_at_work=False, project=SimpleNamespace(batches=batches)
    )
    detectors = SimpleNamespace(result=None, choice=SimpleNamespace(path="", name=""))
    docks = SimpleNamespace(is_open=lambda _: False, with_keyboard=lambda _: "")
    workspace = SimpleNamespace(docks=docks, floor_wanted=False)
    return SimpleNamespace(
        document=document if given.get("recording", True) else None,
        busy=given.get("busy", False),
        live=given.get("live", False),
        unkept=given.get("unkept", False),
        view_options=given.get("view_options", ViewOptions(trails=False)),
        cameras="left",
        of=controllers.__getitem__,
        open=SimpleNamespace(
            labelling=controllers[LabelController],
            reviewing=controllers[ReviewController],
            comparing=SimpleNamespace(shown=False),
            close_up=SimpleNamespace(active=False),
            tracking=SimpleNamespace(best="flow", why_not="", following=SimpleNamespace(on=False)),
            live=SimpleNamespace(stopping=False),
            playback=SimpleNamespace(clock=SimpleNamespace(loop=None, event=None)),
        ),
        files=SimpleNamespace(
            detectors=detectors,
            projects=projects,
            beside=SimpleNamespace(compares=False, share=None),
        ),
        window=SimpleNamespace(
            look_choice=SimpleNamespace(look=None),
            language_choice=SimpleNamespace(language=None),
            workspace=workspace,
        ),
    )


def items_of(now: Any) -> dict[str, Any]:
    return {item.command: item for item in CommandRegistry(COMMANDS, now).items()}


def enabled(now: Any) -> set[str]:
    return {name for name, item in items_of(now).items() if item.enabled}
