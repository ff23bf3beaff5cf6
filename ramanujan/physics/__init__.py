"""The paper in floats and arrays: each equation once. The docstring of `ramanujan` lists the files."""
