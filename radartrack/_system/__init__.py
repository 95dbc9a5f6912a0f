"""What commands need of the system: files written at once or not at all, terminals, processes that end."""
