"""The catalogue of scenes that can be rendered, as scenes.toml has them."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from tracking.synthesis import situations
from tracking.synthesis.specs import FloorSpec, LampSpec, PassageSpec, SceneSpec, WallSpec

_FILE = Path(__file__).with_name("scenes.toml")
_PAUSE_S, _SITUATION_S = 2.0, 12.0
"""Before the first of all situations, and for each."""
_ALONE_S = 13.0

Values = Mapping[str, Any]


def _catalogue() -> Iterator[SceneSpec]:
    told = tomllib.loads(_FILE.read_text("utf-8"))
    floors = {name: FloorSpec(**_frozen(values)) for name, values in told["floors"].items()}
    lamps = {name: LampSpec(**_frozen(values)) for name, values in told["lamps"].items()}
    offices = _offices(told["office"], {**told["offices"], **_situations()})
    for name, values in {**told["scenes"], **offices, **told["passages"]}.items():
        made = _frozen(values)
        made["floor"], made["lamp"] = floors[made["floor"]], lamps[made["lamp"]]
        made["walls"] = tuple(WallSpec(**_frozen(wall)) for wall in made.get("walls", ()))
        if "passage" in made:
            made["passage"] = PassageSpec(**_frozen(made["passage"]))
            made["walls"] = _walls(made["passage"])
        yield SceneSpec(name, **made)


def _offices(shared: Values, offices: Mapping[str, Values]) -> dict[str, Values]:
    """Scenes in one office; people do in each what its name says."""
    height = f"straight down, {shared['height_m']:g} m"
    return {
        name: {**shared, **values, "title": f"{values['title']}, {height}", "scenario": name}
        for name, values in offices.items()
    }


def _situations() -> dict[str, Values]:
    """All hard situations one after the other, and each by itself."""
    numbers = range(1, situations.COUNT + 1)
    people = [situations.people_in(number) for number in numbers]
    seconds = _PAUSE_S + situations.COUNT * _SITUATION_S
    together = {"title": "Fifteen hard situations", "people": sum(people), "seconds": seconds}
    alone = {
        f"situation-{number}": {
            "title": f"Hard situation {number} of {situations.COUNT}",
            "people": count,
            "seconds": _ALONE_S,
        }
        for number, count in zip(numbers, people, strict=True)
    }
    return {"situations": together, **alone}


def _walls(passage: PassageSpec) -> tuple[WallSpec, ...]:
    """The walls of a passage, beside its near mouth and of the cross passage behind it."""
    half, along = passage.half_width_m, (passage.near_m, passage.far_m)
    return (
        WallSpec("x", -half, span_m=along),
        WallSpec("x", half, span_m=along),
        WallSpec("y", passage.near_m, span_m=(-float("inf"), -half)),
        WallSpec("y", passage.near_m, span_m=(half, float("inf"))),
        WallSpec("y", passage.far_m + 3.0, "brick"),
    )


def _frozen(values: Values) -> dict[str, Any]:
    """Values as dataclasses keep them: tuples for lists, and for lists in them."""
    return {key: _as_tuple(value) for key, value in values.items()}


def _as_tuple(value: Any) -> Any:
    return tuple(map(_as_tuple, value)) if isinstance(value, list) else value


SCENES: Mapping[str, SceneSpec] = MappingProxyType({scene.name: scene for scene in _catalogue()})
"""Scenes by name, the papers' camera set-ups among them ([Kawashita2012], [Kawashita2014],
[ZhaoLee2009], [Waechter2013], [Yoneji2013])."""
