"""Every text is translated into every language that has a catalogue, and can be filled."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests import languages
from tests.catalogue import extract
from tests.languages import path_of, read, texts_of, translations

LANGUAGES = languages.languages()
_PLACES = re.compile(r"\{[^}]*\}")
_WORDS = re.compile(r"[A-Za-z]{4,}")


@pytest.fixture(scope="module")
def template():
    return extract()


def test_japanese_is_there() -> None:
    assert "ja" in LANGUAGES


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_text_is_untranslated_guessed_or_obsolete(language, template) -> None:
    """Otherwise: python -m tests.catalogue --missing."""
    catalogue = read(path_of(language))
    wanted = {texts_of(message) for message in languages.messages(template)}
    assert sorted(wanted - translations(catalogue).keys()) == []
    assert sorted(translations(catalogue).keys() - wanted) == []
    assert catalogue.obsolete == {}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_translation_has_the_places_of_its_text(language) -> None:
    assert list(languages.faults(read(path_of(language)))) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_translations_have_as_many_lines_as_their_text(language) -> None:
    other = [
        (texts[-1], said[0])
        for texts, said in translations(read(path_of(language))).items()
        if texts[-1].count("\n") != said[0].count("\n")
    ]
    assert other == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_catalogue_is_as_it_is_made_and_the_compiled_one_is_its(language, template) -> None:
    """Otherwise: make messages."""
    made = languages.update_of(language, template)
    assert path_of(language).read_bytes() == languages.po_of(made)
    assert path_of(language, "mo").read_bytes() == languages.mo_of(made)


def test_japanese_texts_are_japanese() -> None:
    """Names of formats, measures and programs stay; sentences do not."""
    same = [
        texts[-1]
        for texts, said in translations(read(path_of("ja"))).items()
        if texts[-1] == said[0]
        and len(_WORDS.findall(_PLACES.sub("", texts[-1]))) > 3
        and not texts[-1].startswith("pip install ")
    ]
    assert same == []


def test_texts_that_are_missing_are_listed_and_can_be_added(tmp_path: Path, template) -> None:
    made = languages.update_of("ja", template)
    done = translations(made)
    few = dict(list(done.items())[:3])
    partly = languages.joined("ja", template, {key: done[key] for key in list(done)[3:]})
    left = languages.missing(partly)
    assert {texts_of(message) for message in languages.messages(left)} == few.keys()
    for message in languages.messages(left):
        said = few[texts_of(message)]
        message.string = said if isinstance(message.id, tuple) else said[0]
    file = tmp_path / "few.po"
    file.write_bytes(languages.po_of(left))
    added = translations(read(file))
    assert translations(languages.joined("ja", template, translations(partly), added)) == done
