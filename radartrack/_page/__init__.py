"""What the checker's page asks, answered by the library itself: in a browser, without processes, threads, terminal."""
