"""What public functions share: checked arguments, large arrays in blocks on all cores, machine code, single plots."""
