"""What an editor can ask of a program, one file a feature: lines and columns in, plain data out. Knows no protocol."""
