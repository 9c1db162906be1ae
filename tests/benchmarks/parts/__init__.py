"""How well body parts are tracked: scenes, the paper's measures, the report."""
