-- Starts the server where there is no `vim.lsp.enable` (Neovim 0.7 to 0.10): one for each folder with a marker above the program.
local config = dofile(vim.api.nvim_get_runtime_file('lsp/deburr.lua', false)[1])
local started = {}

local function root_of(buffer)
  local folder = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(buffer), ':p:h')
  local above = vim.fn.escape(folder, ' ,;\\') .. ';'
  for _, marker in ipairs(config.root_markers) do
    local file = vim.fn.findfile(marker, above)
    local found = file ~= '' and file or vim.fn.finddir(marker, above)
    if found ~= '' then
      return vim.fn.fnamemodify(vim.fn.substitute(found, '/$', '', ''), ':p:s?/$??:h')
    end
  end
  return folder
end

local function attach(buffer)
  if vim.bo[buffer].buftype ~= '' then
    return
  end
  local root = root_of(buffer)
  if not (started[root] and vim.lsp.get_client_by_id(started[root])) then
    started[root] = vim.lsp.start_client({
      name = 'deburr', cmd = config.cmd, root_dir = root, init_options = config.init_options,
    })
  end
  if started[root] then
    vim.lsp.buf_attach_client(buffer, started[root])
  end
end

local M = {}

-- Start servers for programs from now on. `wishes`: `cmd`, `filetypes`, `root_markers`, `init_options` in place of those in lsp/deburr.lua.
function M.enable(wishes)
  config = vim.tbl_extend('force', config, wishes or {})
  vim.api.nvim_create_autocmd('FileType', {
    group = vim.api.nvim_create_augroup('deburr', {}),
    pattern = config.filetypes,
    callback = function(event) attach(event.buf) end,
  })
end

return M
