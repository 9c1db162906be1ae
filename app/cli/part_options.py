"""Options of `track` that become settings of those trackers that have them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

from app.cli.option_groups import Order
from app.cli.sessions import open_session
from tracking.detections.catalogue import picture_detector
from tracking.errors import FormatError, SessionError, SettingsError
from tracking.failure import load_detector
from tracking.trackers import (
    BUILT_IN_DETECTORS,
    TrackerSpec,
    body_part_tracker,
    occluders_as_setting,
    settings_fields,
)


def settings_texts(spec: TrackerSpec, order: Order) -> tuple[str, ...]:
    """KEY=VALUE of all settings the order names, by --set or by an option of their own.

    Raises:
        SettingsError: the tracker has no such setting, or there is no such detector.
        FormatError: the detector cannot be read, or there are no such detections.
        SessionError: the occluders' session cannot be read, or nothing is drawn in it.
    """
    _refuse_unknown(spec, order)
    return texts_of_options(order)


def texts_of_options(order: Order) -> tuple[str, ...]:
    """The same where the tracker is not known yet; raises as `settings_texts`."""
    texts = list(order.setting or ())
    texts += [f"{name}={value}" for name, value in _named(order)]
    return tuple(texts)


def _refuse_unknown(spec: TrackerSpec, order: Order) -> None:
    """Refuse an option whose setting the tracker does not have; raises SettingsError."""
    given = {
        "detector": ("detector", order.detector),
        "occluders": ("occluders", order.occluders),
        "detections": ("detections.file", order.detections),
        "detections-right": ("detections.file_right", order.detections_right),
        "model": ("detections.appearance", order.model),
    }
    known = {field.name for field in settings_fields(spec.settings_type)}
    for name, (setting, value) in given.items():
        if value is not None and setting not in known:
            raise SettingsError(
                "tracker {tracker} knows no {name}: leave --{name} out or choose {able}",
                tracker=spec.name,
                name=name,
                able=body_part_tracker(),
            )


def refuse_missing_detector(name: str) -> None:
    """Refuse a detector that is named, by an option or a setting, and is not there.

    Raises SettingsError; "" and `BUILT_IN_DETECTORS` name built-in ones.
    """
    if name.strip() not in ("", *BUILT_IN_DETECTORS) and not Path(name.strip()).exists():
        raise SettingsError("{name}: there is no such detector; check the path", name=name.strip())


def _named(order: Order) -> Iterator[tuple[str, str]]:
    if order.detector is not None:
        refuse_missing_detector(str(order.detector))
        if str(order.detector) not in BUILT_IN_DETECTORS:
            load_detector(order.detector)  # told before any work where it cannot be read
        yield "detector", str(order.detector)
    if order.detections is not None:
        yield "detections.file", _absolute(order.detections)
    if order.detections_right is not None:
        _refuse_right_alone(order)
        yield "detections.file_right", _absolute(order.detections_right)
    if order.model is not None:
        if not order.model.exists() and picture_detector(str(order.model)) is not None:
            _refuse_both(order)
            yield "detections.model", str(order.model)
        elif _is_appearance(order.model):
            yield "detections.appearance", _absolute(order.model)
        else:
            _refuse_both(order)
            yield "detections.model", _absolute(order.model)
    if order.occluders is not None:
        yield "occluders", _drawn_in(order.occluders)


def _is_appearance(model: Path) -> bool:
    from tracking.networks.model_file import is_appearance  # help needs no networks

    return is_appearance(model)


def _refuse_right_alone(order: Order) -> None:
    """Refuse detections of the right camera without those of the left, in words of the options."""
    set_names = {text.partition("=")[0].strip() for text in order.setting or ()}
    if order.detections is None and "detections.file" not in set_names:
        raise SettingsError(
            "--detections-right {path}: detections of the right camera alone are not enough; give "
            "those of the left one with --detections",
            path=order.detections_right,
        )


def _refuse_both(order: Order) -> None:
    """Refuse a network beside a file of detections, in words of the options."""
    if order.detections is not None or order.detections_right is not None:
        raise SettingsError(
            "--model {path}: people are detected by a network or by a file of detections; leave "
            "out --model or --detections",
            path=order.model,
        )


def _absolute(path: Path) -> str:
    """A file's place whatever folder it is read from; a link stays one."""
    if not path.exists():
        raise FormatError("{path}: there is no such file; check the path", path=path)
    return str(path.absolute())


def _drawn_in(path: Path) -> str:
    with closing(open_session(path)) as session:
        occluders = session.labels.occluders
    if not occluders:
        raise SessionError(
            "{path}: no occluders are drawn in it; draw some or leave it out", path=path
        )
    return occluders_as_setting(occluders)
