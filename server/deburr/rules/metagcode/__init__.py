"""Rules of MetaGCODE: `spec/metagcode.md` §6."""
