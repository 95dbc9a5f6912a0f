"""How beliefs about many tracks are moved and updated: arrays with the tracks along the last axis."""
