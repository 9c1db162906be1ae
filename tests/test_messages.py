"""Messages are the English sentence, and say the same in another language where they are shown."""

from __future__ import annotations

import ast
import copy
import json
import math
import re
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import pytest

from tests.catalogue import ERRORS, Use, called, uses, uses_in_templates
from tests.pseudo import Pseudo
from tracking.errors import FormatError, TrackwrightError
from tracking.message_data import message_data, message_from
from tracking.translation import (
    Message,
    all_of,
    count_msg,
    joined,
    joined_text,
    message_of,
    msg,
    some_of,
    tr,
    use_catalogue,
)


def places_in(template: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(template) if name is not None}


@pytest.fixture(scope="module")
def all_uses() -> list[Use]:
    return list(uses())


def test_no_error_is_raised_with_a_text_that_cannot_be_translated(all_uses: list[Use]) -> None:
    bare = [
        f"{use.place}:{use.call.lineno}"
        for use in all_uses
        if called(use.call) in ERRORS
        for argument in use.call.args[:2]
        if isinstance(argument, ast.JoinedStr | ast.BinOp)
    ]
    assert bare == []


def test_counts_name_their_texts_where_they_are_told(all_uses: list[Use]) -> None:
    """Texts that come from elsewhere are in no catalogue."""
    unnamed = [
        f"{use.place}:{use.call.lineno}"
        for use in all_uses
        if called(use.call) == "count_text" and len(use.texts) < 2
    ]
    assert unnamed == []


def test_the_places_of_a_template_are_the_values_it_is_given(all_uses: list[Use]) -> None:
    wrong = []
    for use in all_uses:
        places = [places_in(text) for text in use.texts] if use.values else []
        if any(found - (use.values or set()) for found in places):
            wrong.append(f"{use.place}:{use.call.lineno}: a value is missing")
        if places and (use.values or set()) - {"n"} - set().union(*places):
            wrong.append(f"{use.place}:{use.call.lineno}: a value is not used")
    assert wrong == []


def test_texts_of_templates_of_pages_have_the_values_they_are_given() -> None:
    wrong = [
        f"{place}: {text}"
        for texts, values, place in uses_in_templates()
        for text in texts
        if places_in(text) ^ (values - ({"n"} if len(texts) == 2 else set()))
    ]
    assert wrong == []


def test_no_value_of_a_message_is_an_english_word_that_is_never_translated(
    all_uses: list[Use],
) -> None:
    english = [
        f"{use.place}:{use.call.lineno}: {keyword.arg}"
        for use in all_uses
        for keyword in use.call.keywords
        if keyword.arg != "option"
        for word in words_in(keyword.value)
        if re.search("[a-z]{2}", word)
    ]
    assert english == []


def words_in(value: ast.expr) -> Iterator[str]:
    """The texts that stand in a value, whatever it depends on; not those of calls in it."""
    if isinstance(value, ast.Constant):
        yield value.value if isinstance(value.value, str) else ""
    elif isinstance(value, ast.IfExp):
        yield from (*words_in(value.body), *words_in(value.orelse))
    elif isinstance(value, ast.BoolOp | ast.JoinedStr):
        for each in value.values:
            yield from words_in(each)


def test_a_message_is_its_english_sentence() -> None:
    message = msg("{path}, line {line}: {text!r} at {fps:.1f}", path="a", line=3, text="b", fps=25)
    assert message == "a, line 3: 'b' at 25.0"
    assert {message: 1}["a, line 3: 'b' at 25.0"] == 1
    assert type(str(message)) is str


@pytest.mark.usefixtures("pseudo")
def test_messages_within_a_message_are_translated_with_it() -> None:
    where = msg("in frames {start} to {last}", start=1, last=2)
    assert tr(msg("Swap {a} {where}", a=4, where=where)) == "⟦Swap 4 ⟦in frames 1 to 2⟧⟧"
    assert tr("Swap {a} {where}", a=4, where=where) == "⟦Swap 4 ⟦in frames 1 to 2⟧⟧"


@pytest.mark.usefixtures("pseudo")
def test_counts_are_translated_by_their_number() -> None:
    assert count_msg(1, "{n} frame", "{n} frames") == "1 frame"
    assert tr(count_msg(2, "{n} frame", "{n} frames")) == "⟦2 frames⟧"


class Semicolons(Pseudo):
    """A language that separates the items of a list otherwise."""

    def gettext(self, message: str) -> str:
        return {", ": "; ", "{first} and {last}": "{first} + {last}"}.get(message, message)


def test_lists_are_written_as_the_language_writes_them_and_keep_their_values() -> None:
    four = msg("{names} differ", names=all_of(["a", 2, msg("c"), "d"]))
    few = msg("only {names}", names=some_of([4, 7, 9], 2))
    assert (four, few) == ("a, 2, c and d differ", "only 4, 7 and 1 more")
    assert (all_of([]), all_of([4]), some_of([4, 7], 2)) == ("", "4", "4, 7")
    kept = message_from(json.loads(json.dumps(message_data(four))))
    use_catalogue(Semicolons())
    try:
        assert tr(four) == tr(kept) == "a; 2; c + d differ"
        assert tr(few) == "only 4; 7 and 1 more"
        assert joined_text(", ", ["x", 3]) == "x; 3"
    finally:
        use_catalogue(None)


@pytest.mark.usefixtures("pseudo")
def test_an_error_is_translated_with_the_error_it_tells_of() -> None:
    inner = ValueError(msg("the part {text!r} is none", text="x"))
    error = FormatError("{place}: {error}", "name another {what}", place=3, error=inner, what="one")
    assert str(error) == "3: the part 'x' is none; name another one"
    assert "⟦the part 'x' is none⟧" in tr(error.message)
    assert "⟦name another one⟧" in tr(error.message)
    assert message_of(error) == str(error)


def test_an_option_of_the_command_line_ends_the_line_and_stands_by_itself() -> None:
    error = TrackwrightError("a has no format", "choose one", option="--format")
    assert str(error) == "a has no format; choose one (--format)"
    assert (error.to_do, error.option) == ("choose one", "--format")


def test_a_text_without_values_may_hold_braces() -> None:
    assert str(FormatError("{} is JSON")) == "{} is JSON"


class Short(Pseudo):
    def gettext(self, _message: str) -> str:
        return "{missing} of {n}"


def test_a_translation_that_cannot_be_filled_leaves_the_text_english() -> None:
    use_catalogue(Short())
    try:
        assert tr("{path} is empty", path="a") == "a is empty"
    finally:
        use_catalogue(None)


@pytest.mark.usefixtures("pseudo")
def test_a_very_long_error_is_cut_in_every_language() -> None:
    error = FormatError("{text} is no number", text="9" * 50_000)
    assert len(str(error)) < 3000
    assert len(tr(error.message)) < 3000
    assert tr(error.message).endswith("is no number⟧")


@pytest.mark.parametrize("number", [math.nan, math.inf, -math.inf])
def test_numbers_that_json_does_not_hold_are_kept_as_numbers(number: float) -> None:
    message = msg("a height of {height_m:.2f} m", height_m=number)
    kept = message_from(json.loads(json.dumps(message_data(message), allow_nan=False)))
    assert kept == message


@pytest.mark.usefixtures("pseudo")
def test_a_message_is_copied_and_kept_as_data_with_its_parts() -> None:
    message = msg(
        "{a}: {frames} {names} at {fps:g}",
        a=Path("a"),
        frames=count_msg(2, "{n} frame", "{n} frames"),
        names=joined(", ", ["x", msg("y")]),
        fps=12.5,
    )
    for same in (
        copy.deepcopy(message),
        message_from(json.loads(json.dumps(message_data(message)))),
    ):
        assert isinstance(same, Message)
        assert same == message == "a: 2 frames x, y at 12.5"
        assert tr(same) == tr(message)


@pytest.mark.parametrize(
    "data",
    [
        3,
        {},
        {"text": 3},
        {"text": "{a}", "values": {}, "many": "{n}"},
        {"text": "{a.real}", "values": {"a.real": 1}},
        {"text": "{a.__class__}", "values": {"a": 1}},
        {"text": "{a:99999999}", "values": {"a": 1}},
        {"text": "{a:{b}}", "values": {"a": 1, "b": "9999999"}},
        {"text": "{a:zz}", "values": {"a": 1}},
        {"text": "{a" * 10, "values": {"a": 1}},
        {"text": "{a}" * 2000, "values": {"a": 1}},
        {"text": "{a}", "values": [1]},
        {"text": "{a}", "values": {"a": [1]}},
    ],
)
def test_data_that_is_no_message_is_refused(data: object) -> None:
    with pytest.raises(ValueError, match=r"\w"):
        message_from(data)


def test_data_nested_without_end_is_refused() -> None:
    data: object = "end"
    for _ in range(500):
        data = {"text": "{a}", "values": {"a": data}}
    with pytest.raises(ValueError, match="a message is a text"):
        message_from(data)


def test_values_of_a_message_are_changed_wherever_they_are_nested() -> None:
    inner = Message("{path} is damaged", path=Path("/a/copy"))
    outer = Message(
        "{n} edit of {name}: {why}", "{n} edits of {name}: {why}", n=2, name=7, why=inner
    )

    def named(value: object) -> object:
        return Path("/mine") if isinstance(value, Path) else value

    assert str(outer.with_values(named)) == "2 edits of 7: /mine is damaged"
    assert outer.with_values(named).translated() == "2 edits of 7: /mine is damaged"
    assert "/a/copy" in outer
