"""How well a flow of people is counted from tracklets: scenes, measures, the report."""
