-- The server, as `vim.lsp.enable('deburr')` finds it (Neovim 0.11 and later).
return {
  cmd = { 'deburr', 'server' },
  filetypes = require('deburr.filetypes'),
  root_markers = { 'deburr.toml', 'pyproject.toml', '.git' },
}
