"""The template of translations holds every text of the program."""

from tests.catalogue import TEMPLATE, extract, template_of


def test_the_template_holds_every_text() -> None:
    """Otherwise: make messages."""
    assert TEMPLATE.read_bytes() == template_of(extract())
