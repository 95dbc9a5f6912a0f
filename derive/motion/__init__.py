"""How targets move from scan to scan: transitions and process noise."""
