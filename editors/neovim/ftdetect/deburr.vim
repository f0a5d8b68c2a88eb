" Written by `python -m deburr.dev.generate`.
autocmd BufNewFile,BufRead *.mgc setfiletype metagcode
autocmd BufNewFile,BufRead *.ngc setfiletype rs274
autocmd BufNewFile,BufRead *.cgt setfiletype cgt
autocmd BufNewFile,BufRead *.z32 setfiletype z32
autocmd BufNewFile,BufRead *.nc,*.tap,*.cnc,*.gcode setfiletype gcode
