"""Pictures that stand in the page itself."""

from __future__ import annotations

import base64

from tracking.pages.elements import Element, element


def picture(jpeg: bytes, says: str) -> Element:
    """A JPEG image.

    Args:
        says: what it shows, for those who do not see it.
    """
    return element("img", src=jpeg_source(jpeg), alt=says)


def jpeg_source(jpeg: bytes) -> str:
    """The address of an image that is in the address itself."""
    return f"data:image/jpeg;base64,{base64.b64encode(jpeg).decode()}"
