"""The pictures in `docs/`, made from the real window on a virtual screen."""
