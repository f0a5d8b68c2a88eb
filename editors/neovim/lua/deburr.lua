-- The expanded program in a buffer of its own, and the way from its lines to those that made them. Never starts a server.
local M = {}
local SCHEME = 'deburr-expanded:'

local function client_of(buffer)
  local all = vim.lsp.get_clients and vim.lsp.get_clients({ bufnr = buffer }) or vim.lsp.buf_get_clients(buffer)
  for _, client in pairs(all) do
    if client.name == 'deburr' then
      return client
    end
  end
end

-- Run one of the server's commands for a source buffer; `done` is called with what it gives.
local function execute(buffer, command, argument, done)
  local client = client_of(buffer)
  if not client then
    vim.notify('deburr: no server is attached to ' .. vim.api.nvim_buf_get_name(buffer), vim.log.levels.WARN)
    return
  end
  local params = { command = command, arguments = { argument } }
  local function handler(err, result)
    if err then
      vim.notify('deburr: ' .. err.message, vim.log.levels.ERROR)
    elseif result and result ~= vim.NIL then
      done(result, client)
    end
  end
  if vim.fn.has('nvim-0.11') == 1 then
    client:request('workspace/executeCommand', params, handler, buffer)
  else
    client.request('workspace/executeCommand', params, handler, buffer)
  end
end

local function given(define)
  return next(define) and define or nil
end

local function flat_uri(source)
  return SCHEME .. vim.uri_from_bufnr(source):gsub('^file://', '')
end

local function show(buffer)
  local window = vim.fn.bufwinid(buffer)
  if window ~= -1 then
    vim.api.nvim_set_current_win(window)
  else
    vim.cmd('vertical sbuffer ' .. buffer)
  end
end

local function put_cursor(row)
  vim.api.nvim_win_set_cursor(0, { math.min(row + 1, vim.api.nvim_buf_line_count(0)), 0 })
end

local function flat_buffer(source)
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    local ok, of = pcall(vim.api.nvim_buf_get_var, buffer, 'deburr_source')
    if ok and of == source then
      return buffer
    end
  end
  local buffer = vim.api.nvim_create_buf(true, true)
  -- With `//` behind its scheme Neovim takes the name for what it is, not for a path below the working folder.
  vim.api.nvim_buf_set_name(buffer, SCHEME .. '//' .. vim.api.nvim_buf_get_name(source))
  vim.api.nvim_buf_set_var(buffer, 'deburr_source', source)
  vim.keymap.set('n', '<CR>', M.to_source, { buffer = buffer, desc = 'To the line that made this one' })
  vim.keymap.set('n', 'R', M.again, { buffer = buffer, desc = 'Expand again' })
  return buffer
end

local function fill(buffer, text, define)
  local lines = vim.split(text:gsub('\r\n?', '\n'), '\n', { plain = true })
  if lines[#lines] == '' then
    table.remove(lines)
  end
  vim.bo[buffer].modifiable = true
  vim.api.nvim_buf_set_lines(buffer, 0, -1, false, lines)
  vim.bo[buffer].modifiable = false
  vim.b[buffer].deburr_define = define
end

local function complain(found)
  for _, finding in ipairs(found.findings) do
    if finding.severity == 1 then
      local at = finding.range.start
      vim.notify(('deburr: not expanded: line %d: %s'):format(at.line + 1, finding.message), vim.log.levels.ERROR)
      return true
    end
  end
end

-- Show the flat program of a buffer, the cursor on the first line that came from the one it stood on.
function M.expand(define, source)
  source = source or vim.api.nvim_get_current_buf()
  local row = vim.api.nvim_win_get_cursor(0)[1] - 1
  local uri = vim.uri_from_bufnr(source)
  execute(source, 'deburr.expand', { uri = uri, define = given(define) }, function(found)
    if found.text == '' and complain(found) then
      return
    end
    local buffer = flat_buffer(source)
    fill(buffer, found.text, define)
    show(buffer)
    if found.truncated then
      vim.notify('deburr: the program is longer than this; it was cut here', vim.log.levels.WARN)
    end
    local position = { line = row, character = 0 }
    execute(source, 'deburr.sourceMap', { uri = uri, position = position, define = given(define) }, function(there)
      if there.ranges[1] and vim.api.nvim_get_current_buf() == buffer then
        put_cursor(there.ranges[1].range.start.line)
      end
    end)
  end)
end

-- Expand again what the current buffer is the flat program of.
function M.again()
  local source, define = vim.b.deburr_source, vim.b.deburr_define
  show(source)
  M.expand(define, source)
end

-- Go from a line of a flat program to the line that made it; says the calls and loop passes above it.
function M.to_source()
  local source = vim.b.deburr_source
  local position = { line = vim.api.nvim_win_get_cursor(0)[1] - 1, character = 0 }
  local argument = { uri = flat_uri(source), position = position, define = given(vim.b.deburr_define) }
  execute(source, 'deburr.sourceMap', argument, function(found)
    local origin = found.ranges[1]
    if not origin then
      return
    end
    local buffer = vim.uri_to_bufnr(found.uri)
    vim.fn.bufload(buffer)
    show(buffer)
    put_cursor(origin.range.start.line)
    local above = {}
    for _, frame in ipairs(origin.frames) do
      local what = frame.kind == 'loop' and 'pass ' .. frame.number or frame.kind
      local file = vim.fn.fnamemodify(vim.uri_to_fname(frame.uri), ':t')
      table.insert(above, ('%s, %s:%d'):format(what, file, frame.row + 1))
    end
    vim.api.nvim_echo({ { table.concat(above, ' <- ') } }, false, {})
  end)
end

return M
