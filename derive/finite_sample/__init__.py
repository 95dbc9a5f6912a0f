"""The least-squares polynomial filter over the last k scans (growing memory), in closed form."""
