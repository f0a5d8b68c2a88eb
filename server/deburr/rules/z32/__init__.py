"""The rules of D.Electron Z32 (spec/z32.md §8)."""
