"""The pictures in `docs/images/`, made from the real window on a virtual screen."""
