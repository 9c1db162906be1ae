"""Texts come from the catalogue of the language that is asked for."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from babel.messages.catalog import Catalog
from babel.messages.mofile import write_mo

from tracking import translation
from tracking.translation import count_text, tr, use_catalogue, use_language


@pytest.fixture
def japanese(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    catalogue = Catalog(locale="ja")
    catalogue.add("Swap {a} with...", "{a} \u3092\u5165\u308c\u66ff\u3048...")
    catalogue.add(("{n} frame", "{n} frames"), ("{n} \u30d5\u30ec\u30fc\u30e0",))
    path = tmp_path / "ja" / "LC_MESSAGES" / "trackwright.mo"
    path.parent.mkdir(parents=True)
    with path.open("wb") as file:
        write_mo(file, catalogue)
    monkeypatch.setattr(translation, "CATALOGUES", tmp_path)
    yield
    use_catalogue(None)


@pytest.mark.usefixtures("japanese")
def test_a_language_is_chosen_by_its_name() -> None:
    use_language("ja")
    assert tr("Swap {a} with...", a=4) == "4 \u3092\u5165\u308c\u66ff\u3048..."
    assert count_text(1, "{n} frame", "{n} frames") == "1 \u30d5\u30ec\u30fc\u30e0"
    assert count_text(2, "{n} frame", "{n} frames") == "2 \u30d5\u30ec\u30fc\u30e0"


@pytest.mark.usefixtures("japanese")
def test_the_environment_names_the_language(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LANGUAGE", "ja")
    use_language()
    assert tr("Swap {a} with...", a=4).startswith("4 \u3092")


@pytest.mark.usefixtures("japanese")
def test_without_a_catalogue_and_without_a_translation_texts_stay_english() -> None:
    use_language("fr")
    assert tr("Swap {a} with...", a=4) == "Swap 4 with..."
    use_language("ja")
    assert tr("Open...") == "Open..."
    assert tr("") == ""
