-- `:DeburrExpand [NAME=VALUE ...]`: the flat program of the current buffer. The code lens `Expand` does the same.
local function expand(words)
  local define = {}
  for _, word in ipairs(words) do
    local name, value = word:match('^(.-)=(.*)$')
    if not name then
      vim.notify('deburr: `' .. word .. '` is not NAME=VALUE', vim.log.levels.ERROR)
      return
    end
    define[name] = value
  end
  require('deburr').expand(define)
end

vim.api.nvim_create_user_command('DeburrExpand', function(given) expand(given.fargs) end,
  { nargs = '*', desc = 'Show the program that the control would execute' })
vim.lsp.commands['deburr.expand'] = function() expand({}) end
