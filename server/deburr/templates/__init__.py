"""Templates with `@` sections: their bodies, items and words as rules and the interpreter see them. Reports nothing, runs nothing."""
