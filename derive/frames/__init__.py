"""Where things stand: on the Earth, before a site, before the face of a radar."""
