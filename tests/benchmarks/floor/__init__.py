"""How far the floor that is found is from the one given."""
