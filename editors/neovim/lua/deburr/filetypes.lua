-- Written by `python -m deburr.dev.generate`.
return { 'metagcode', 'rs274', 'cgt', 'z32', 'gcode' }
