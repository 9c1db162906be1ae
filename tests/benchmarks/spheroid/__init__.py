"""How well spheroids on the floor follow people with one camera: scenes, measures, the report."""
