-- What a user does in Neovim with one program, and what is seen of it. PLAN: a file with what to do; FACTS: where to write it down.
local plan = vim.json.decode(io.open(vim.env.PLAN):read('*a'))
local facts = io.open(vim.env.FACTS, 'w')

local function say(what, value)
  facts:write(vim.json.encode({ what, value }) .. '\n')
  facts:flush()
end

local function wait(what, test)
  if not vim.wait(30000, test, 10) then
    say('waited in vain', what)
    vim.cmd('cquit 1')
  end
end

local function place(text)
  vim.fn.cursor(1, 1)
  if vim.fn.search('\\V' .. vim.fn.escape(text, '\\'), 'c') == 0 then
    say('not in the program', text)
    vim.cmd('cquit 1')
  end
end

local function lines(buffer)
  return vim.api.nvim_buf_get_lines(buffer or 0, 0, -1, false)
end

local function name(buffer)
  return vim.fn.fnamemodify(vim.api.nvim_buf_get_name(buffer or 0), ':t')
end

local function here()
  return name() .. ':' .. vim.fn.line('.')
end

local function errors()
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(0)) do
    if each.severity == vim.diagnostic.severity.ERROR then
      table.insert(found, ('%d:%d %s'):format(each.lnum + 1, each.col + 1, each.message))
    end
  end
  return found
end

local function float()
  for _, window in ipairs(vim.api.nvim_list_wins()) do
    if vim.api.nvim_win_get_config(window).relative ~= '' then
      return window
    end
  end
end

local function is_flat()
  return vim.api.nvim_buf_get_name(0):match('^deburr%-expanded:')
end

vim.cmd('edit ' .. vim.fn.fnameescape(plan.main))
local main = vim.api.nvim_get_current_buf()
say('version', ('%d.%d'):format(vim.version().major, vim.version().minor))
say('filetype', vim.bo.filetype)
say('commentstring', vim.bo.commentstring)
wait('diagnostics', function() return #errors() > 0 end)
say('errors', errors())

-- The first of the actions that are offered is chosen, as a user types it.
place(plan.fault)
local before = vim.fn.getline('.')
vim.api.nvim_feedkeys('1\r', 't', false)
vim.lsp.buf.code_action()
wait('the code action', function() return vim.fn.getline('.') ~= before end)
say('mended', vim.fn.getline('.'))
wait('no diagnostics', function() return #errors() == 0 end)
vim.cmd('silent write')

place(plan.hover)
vim.lsp.buf.hover()
wait('hover', float)
say('hover', table.concat(lines(vim.api.nvim_win_get_buf(float())), '\n'))
vim.api.nvim_win_close(float(), true)

place(plan.definition)
before = here()
vim.lsp.buf.definition()
wait('the definition', function() return here() ~= before end)
say('definition', here())
vim.cmd('buffer ' .. main)

place(plan.rename[1])
before = vim.fn.getline('.')
vim.lsp.buf.rename(plan.rename[2])
wait('the new name', function() return vim.fn.getline('.') ~= before end)
local texts = {}
for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
  if vim.api.nvim_buf_is_loaded(buffer) and vim.bo[buffer].modified then
    texts[name(buffer)] = lines(buffer)
  end
end
say('renamed', texts)
vim.cmd('silent wall')

place(plan.expand.from)
vim.cmd('DeburrExpand ' .. plan.expand.define)
wait('the flat program', is_flat)
say('flat', lines())
wait('the line of the flat program', function() return vim.fn.line('.') == plan.expand.to end)
vim.fn.cursor(plan.expand.line, 1)
vim.api.nvim_feedkeys(vim.api.nvim_replace_termcodes('<CR>', true, false, true), 'x', false)
wait('the source', function() return not is_flat() end)
say('source', here())
say('error', vim.v.errmsg)
vim.cmd('qall!')
