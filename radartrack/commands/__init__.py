"""The commands, one a module; heavy imports wait until a command runs."""
