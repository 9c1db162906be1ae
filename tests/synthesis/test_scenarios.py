"""People who walk as a script says."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from tracking.errors import SettingsError
from tracking.synthesis import SCENES, Scene, render_recording
from tracking.synthesis.cast import scenario_of
from tracking.synthesis.crowd import CLOSEST_M, PlannedWalk
from tracking.synthesis.marks import MARKS_M
from tracking.synthesis.rig import Rig
from tracking.synthesis.scenario import EVERYBODY, Moment

SCENARIOS = sorted(name for name, spec in SCENES.items() if spec.scenario)
SITUATIONS = [name for name in SCENARIOS if name.startswith("situation-")]
FPS = 15.0


@dataclass(frozen=True)
class _Played:
    """A scenario with its walks."""

    walks: tuple[PlannedWalk | None, ...]
    moments: tuple[Moment, ...]


def _played(name: str, seed: int = 1) -> _Played:
    spec = SCENES[name]
    scenario = scenario_of(spec, spec.people, seed)
    return _Played(scenario.walks(round(spec.seconds * FPS), FPS), scenario.moments)


def _table(played: _Played) -> np.ndarray:
    ways = [way for way in played.walks if way is not None]
    table = np.full((max(way.frames.stop for way in ways), len(ways), 2), np.nan)
    for column, way in enumerate(ways):
        table[way.frames.start : way.frames.stop, column] = way.position
    return table


@pytest.mark.parametrize("name", SCENARIOS)
def test_everybody_comes_and_goes_before_a_scenario_ends(name: str) -> None:
    played = _played(name, 7)
    last = round(SCENES[name].seconds * FPS) - 1
    rig = Rig.of_scene(SCENES[name], (640, 480))
    for way in played.walks:
        assert way is not None
        assert way.first_frame >= 2 * FPS
        assert way.frames.stop <= last
        for place in way.position[[0, -1]]:
            assert not rig.sees(rig.view.box_of_person(place[None], 1.7, 0.5)[0])


@pytest.mark.parametrize("name", SCENARIOS)
@pytest.mark.parametrize("seed", [1, 2])
def test_nobody_walks_through_anybody_in_a_scenario(name: str, seed: int) -> None:
    table = _table(_played(name, seed))
    gap = np.linalg.norm(table[:, :, None] - table[:, None], axis=-1)
    gap[:, np.eye(table.shape[1], dtype=bool)] = np.nan
    assert np.nanmin(gap, initial=9.0) >= CLOSEST_M
    speed = np.linalg.norm(np.diff(table, axis=0), axis=-1) * FPS
    assert np.nanmax(speed) < 1.7


@pytest.mark.parametrize("name", ["marks", "marks-pairs"])
def test_people_stand_still_on_their_marks(name: str) -> None:
    played = _played(name)
    stands = [moment for moment in played.moments if moment.kind == "stands"]
    assert sorted(moment.name for moment in stands) == sorted(MARKS_M)
    for moment in stands:
        way = played.walks[moment.person]
        assert way is not None
        rows = slice(*(round(s * FPS) - way.first_frame for s in (moment.start_s, moment.end_s)))
        assert len(way.position[rows]) >= 4 * FPS
        assert np.abs(way.position[rows] - MARKS_M[moment.name]).max() < 0.005
        assert np.ptp(way.heading[rows]) < 0.12


def test_who_walks_the_marks_keeps_to_the_straight_lines_between_them() -> None:
    played = _played("marks-walking")
    way = played.walks[0]
    assert way is not None
    assert len(played.moments) == 9
    for moment in played.moments:
        start, end = (np.array(MARKS_M[mark]) for mark in moment.name.split("-"))
        rows = slice(*(round(s * FPS) - way.first_frame for s in (moment.start_s, moment.end_s)))
        along = (end - start) / np.linalg.norm(end - start)
        off = (way.position[rows] - start) @ np.array([-along[1], along[0]])
        assert np.abs(off).max() < 0.1


def test_there_are_as_many_situations_of_each_difficulty_as_in_the_paper() -> None:
    rated = [_played(f"situation-{number}").moments[0].difficulty for number in range(1, 16)]
    assert rated == [2, 2, 2, 1, 1, 5, 5, 3, 3, 2, 4, 5, 3, 3, 4]


def test_people_come_close_to_each_other_in_the_harder_situations() -> None:
    for number in (6, 7, 8, 9, 11, 12, 13, 14, 15):
        table = _table(_played(f"situation-{number}"))
        gap = np.linalg.norm(table[:, :, None] - table[:, None], axis=-1)
        gap[:, np.eye(table.shape[1], dtype=bool)] = np.nan
        assert np.nanmin(gap) < 0.85


def test_another_seed_is_another_way_of_doing_the_same() -> None:
    one, other = (_table(_played("situation-9", seed)) for seed in (1, 2))
    frames = min(len(one), len(other))
    assert np.nanmax(np.abs(one[:frames] - other[:frames])) > 0.1
    assert np.array_equal(one, _table(_played("situation-9", 1)), equal_nan=True)


def test_all_situations_in_turn_are_those_that_stand_alone() -> None:
    together = _played("situations", 5)
    alone = [_played(f"situation-{number}", 5) for number in range(1, 16)]
    assert [m.name for m in together.moments] == [one.moments[0].name for one in alone]
    assert all(moment.person == EVERYBODY for moment in together.moments)
    shapes = [np.ptp(way.position, axis=0) for one in alone for way in one.walks if way]
    shown = [np.ptp(way.position, axis=0) for way in together.walks if way]
    assert np.allclose(shapes, shown, atol=0.03)


def test_a_scenario_refuses_other_numbers_of_people() -> None:
    with pytest.raises(SettingsError, match="for 2, leave it out"):
        Scene(SCENES["marks-pairs"], people=5, size=(64, 48))


def test_everybody_wears_a_red_top_and_brown_trousers() -> None:
    scene = Scene(SCENES["situation-7"], size=(64, 48))
    cast = scene.cast
    for person in np.split(cast.textures, 4):
        skin = person[: 320 * 256].reshape(320, 256, 3)
        blue, green, red = skin[40:60, 20:230].mean(axis=(0, 1))
        assert red > 4 * max(blue, green)
        blue, green, red = skin[150:240, 10:86].mean(axis=(0, 1))
        assert red > green > blue
        assert red < 0.2
    assert not cast.figures.skirt.any()
    assert not cast.figures.pack.any()


def test_where_everybody_is_and_what_is_looked_at_stand_beside_the_truth(tmp_path: Path) -> None:
    folder = render_recording(tmp_path / "pairs", "marks-pairs", 5.0, size=(64, 48))
    with (folder / "moments.csv").open() as stream:
        moments = list(csv.DictReader(stream))
    assert [(row["id"], row["kind"], row["name"]) for row in moments] == [
        ("1", "stands", "A1"),
        ("2", "stands", "A2"),
    ]
    with (folder / "floor.csv").open() as stream:
        rows = [row for row in csv.DictReader(stream) if row["frame"] == moments[0]["start"]]
    places = [(float(row["x"]), float(row["y"])) for row in rows]
    assert np.allclose(places, [MARKS_M["A1"], MARKS_M["A2"]], atol=0.01)
