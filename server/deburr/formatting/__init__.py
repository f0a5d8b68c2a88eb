"""Layout of programs: what may be laid out says the dialect, what it comes to is proven line by line. Never changes what a program says."""
