"""Pictures that stand in the page itself."""

from __future__ import annotations

import base64

from tracking.pages.elements import Element, element


def picture(jpeg: bytes, says: str) -> Element:
    """A JPEG image.

    Args:
        says: what it shows, for those who do not see it.
    """
    data = base64.b64encode(jpeg).decode()
    return element("img", src=f"data:image/jpeg;base64,{data}", alt=says)
