"""A plan that is opened as a trial, before anything is written."""

from __future__ import annotations

from dataclasses import replace

from app.core.error_messages import explain_in_sentence
from app.core.i18n import tr
from app.features.setup.scene import Checked, Step
from tracking.errors import TrackwrightError
from tracking.recording import MANIFEST_NAME, open_recording
from tracking.recording.region_of_interest import EVERYWHERE
from tracking.setup import SetupPlan
from tracking.setup.calibration_facts import read_facts
from tracking.setup.plan import CALIBRATION_NAME, options_of_plan, setup_text


def check(plan: SetupPlan) -> Checked:
    """Open a plan as a trial, and say what would be written; slow; problems are told."""
    step, checked = Step.CAMERAS, _written(plan)
    try:
        alone = replace(plan, calibration=(), ground=None, region=EVERYWHERE)
        with open_recording(plan.folder, options_of_plan(alone)) as recording:
            size, stereo = recording.size, recording.is_stereo
        if plan.calibration:
            step = Step.CALIBRATION
            facts = read_facts(plan.calibration, size, stereo, plan.topics)
            read, missing = (tuple(map(tr, lines)) for lines in (facts.read, facts.missing))
            checked = replace(checked, calibration=facts.calibration, read=read, missing=missing)
            _open(replace(plan, ground=None, region=EVERYWHERE))
        step = Step.FLOOR
        _open(replace(plan, region=EVERYWHERE))
        step = Step.REGION
        _open(plan)
    except (TrackwrightError, OSError) as error:
        return replace(checked, problem=explain_in_sentence(error), step=step)
    return checked


def _open(plan: SetupPlan) -> None:
    with open_recording(plan.folder, options_of_plan(plan)):
        pass


def _written(plan: SetupPlan) -> Checked:
    """The files as they would be; why there are none stands in their place."""
    try:
        path, copied = plan.folder / MANIFEST_NAME, plan.calibration_file
        text, replaces = setup_text(plan), path.exists()
    except (TrackwrightError, OSError) as error:
        why = explain_in_sentence(error)
        return Checked(plan, text=f"# {why}", places=why)
    places = tr("Will be written: {path}", path=path)
    if copied is not None:
        places = tr("Will be written: {path}, and {name} beside it", path=path, name=copied.name)
        if copied.name != CALIBRATION_NAME:
            stays = tr("{name} there is another one, and stays.", name=CALIBRATION_NAME)
            places = f"{places}\n{stays}"
    return Checked(plan, text=text, places=places, replaces=replaces)
