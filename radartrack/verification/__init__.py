"""How well each generated function is known to be right."""
