-- Written by `python -m deburr.dev.generate`.
vim.bo.commentstring = '; %s'
