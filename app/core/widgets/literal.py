"""Words of people and files, shown as they stand.

Labels and tooltips show plain text by the stylesheet; a message box is told so when it is made,
since it lays its text out before it is styled.
"""

from __future__ import annotations


def literal(text: str) -> str:
    """For buttons, menus and tabs: & is a sign like any other, and marks no key."""
    return text.replace("&", "&&")


def literal_title(text: str) -> str:
    """For titles of windows: [*] is not the place of the mark of unsaved changes."""
    return text.replace("[*]", "[*][*]")
