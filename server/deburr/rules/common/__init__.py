"""Rules that hold in every dialect; one of the same name in a dialect's own folder replaces them there."""
