"""Values put into a recording.toml keep what else its writer wrote."""

from __future__ import annotations

import tomllib

from hypothesis import given
from hypothesis import strategies as st

from tracking.recording.manifest_editor import with_values

TEXT = """# Of the west door
format = 1
fps = 20.0  # as the camera says

[left]   # the one above the door
source = "left # 1.mp4" # from card 2

[right]
source = 'right.mp4'
# lag = 3

[calibration]
file = ["a.yml", "b.yml"]
"""


def test_a_value_is_replaced_and_its_comment_stays() -> None:
    changed = with_values(TEXT, {("left", "source"): '"other.mp4"'})
    assert '[left]   # the one above the door\nsource = "other.mp4" # from card 2' in changed
    assert changed.replace('"other.mp4"', '"left # 1.mp4"') == TEXT


def test_lists_are_replaced_whole_and_missing_keys_and_tables_are_added() -> None:
    values = {
        ("calibration", "file"): '"c.yaml"',
        ("right", "lag"): "2",
        ("stereo", "first"): '"left"',
    }
    told = tomllib.loads(with_values(TEXT, values))
    assert told["calibration"] == {"file": "c.yaml"}
    assert told["right"] == {"source": "right.mp4", "lag": 2}
    assert told["stereo"] == {"first": "left"}
    assert "# lag = 3" in with_values(TEXT, values)


@given(st.integers(-99, 99), st.integers(-99, 99))
def test_the_last_of_two_values_stands(one: int, other: int) -> None:
    text = with_values(TEXT, {("right", "lag"): str(one)})
    again = with_values(text, {("right", "lag"): str(other)})
    assert tomllib.loads(again)["right"]["lag"] == other
    assert again.count("\n") == text.count("\n")
