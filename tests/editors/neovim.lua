-- SPDX-License-Identifier: MIT
-- Tests the language server with a real client: Neovim without a window, configured by the lines in
-- docs/how-to/language-server.md. The script sends each kind of request once, for two files; one of them includes the
-- other. It writes the responses to the file `told`, which must equal the text in docs/how-to/language-server.md.
local wait_ms = 30000
local told = assert(io.open('told', 'w'))

local function fail(what)
    io.stderr:write('neovim: ' .. what .. '\n')
    vim.cmd('cquit')
end
local function say(words) told:write(words .. '\n') end
local function expect(holds, what)
    if not holds then fail(what) end
end
local function await(holds, what)
    if not vim.wait(wait_ms, holds, 5) then fail('waited in vain: ' .. what) end
end

local press = [[
// Press: opens and shuts.
grafcet press {
    input START;
    output MOVE;

    initial step 0;
    step 1 { MOVE; }

    transition t0: 0 -> 1 when START;
    transition t1: 1 -> 0 when 2s/X1;
}
]]
local main = [[
include "press.grafcet";

closed_loop station {
    controller press;

    environment Start = free(OUT = START);

    property still "the press never moves": never MOVE;
    property apart: never X0 && X1;
}
]]
local program = [[
PROGRAM Press
VAR_INPUT Start AT %IX0.0 : BOOL; END_VAR  // from the desk
VAR_OUTPUT Move : BOOL; END_VAR
VAR Delay : TON; END_VAR
Delay(IN := (START), PT := T#2s);
Move := Delay.Q;
END_PROGRAM
]]
-- Returns a loop of ten machines, each of which waits for its neighbour. The check of the loop does not end in time.
local function busy()
    local text = 'grafcet busy {\n'
    for k = 0, 9 do
        text = text .. ('input A%d; output O%d; initial step %d; step %d { O%d; }\n'):format(k, k, 2 * k, 2 * k + 1, k)
        text = text .. ('transition %d -> %d when A%d && !O%d;\n'):format(2 * k, 2 * k + 1, k, (k + 1) % 10)
        text = text .. ('transition %d -> %d when %ds/X%d;\n'):format(2 * k + 1, 2 * k, k + 3, 2 * k + 1)
    end
    text = text .. '}\nclosed_loop all {\n    controller busy;\n'
    for k = 0, 9 do text = text .. ('    environment E%d = free(OUT = A%d);\n'):format(k, k) end
    return text .. '    property goes_on: no deadlock;\n}\n'
end
local function write(name, text)
    local file = assert(io.open(name, 'w'))
    file:write(text)
    file:close()
end

-- Records what the server requests the editor to show, and whether it reports work in progress.
local shown, working = {}, nil
vim.lsp.handlers['window/showMessage'] = function(_, params) table.insert(shown, params.message) end
vim.lsp.handlers['window/showDocument'] = function(_, params)
    table.insert(shown, params.uri)
    return { success = true }
end
vim.lsp.handlers['$/progress'] = function(_, params) working = params.value.kind ~= 'end' end

-- Returns the response of the page `page` to a request of `path`.
local function fetched(page, path)
    local host, port, token = page:match('http://([%d.]+):(%d+)/%?token=(%x+)')
    local link, answer, over = vim.loop.new_tcp(), '', false
    link:connect(host, tonumber(port), function()
        link:write(('GET %s HTTP/1.1\r\nHost: %s:%s\r\nX-Grafverif-Token: %s\r\nConnection: close\r\n\r\n'):format(path, host, port, token))
        link:read_start(function(_, part)
            if part then answer = answer .. part else over = true end
        end)
    end)
    await(function() return over end, path .. ' of ' .. page)
    link:close()
    return answer
end

local function open(name)
    vim.cmd('edit ' .. name)
    local buffer = vim.api.nvim_get_current_buf()
    await(function()
        for _, client in pairs(vim.lsp.buf_get_clients(buffer)) do return client.initialized end
    end, 'the server takes ' .. name)
    return buffer
end

local function session()
    write('press.grafcet', press)
    write('main.grafcet', main)
    write('press.st', program)
    write('busy.grafcet', busy())
    local press_buffer, buffer = open('press.grafcet'), open('main.grafcet')
    local client
    for _, each in pairs(vim.lsp.buf_get_clients(buffer)) do client = each end

    local function ask(method, of, more)
        local params = vim.tbl_extend('force', { textDocument = { uri = vim.uri_from_bufnr(of) } }, more or {})
        local answers, why = vim.lsp.buf_request_sync(of, method, params, wait_ms)
        if not answers then fail(method .. ': ' .. tostring(why)) end
        local _, answer = next(answers)
        if answer.error or answer.err then fail(method .. ': ' .. vim.inspect(answer)) end
        return answer.result
    end
    local function lines(of) return vim.api.nvim_buf_get_lines(of, 0, -1, true) end
    -- Returns the position of `part` in the first line that contains `line`.
    local function at(of, line, part, beyond)
        for number, text in ipairs(lines(of)) do
            if text:find(line, 1, true) then
                return { position = { line = number - 1, character = text:find(part, 1, true) - 1 + (beyond or 0) } }
            end
        end
        fail('there is no ' .. line)
    end
    local function type_instead(of, line, text)
        local number = at(of, line, line).position.line
        vim.api.nvim_buf_set_lines(of, number, number + 1, true, { text })
        say(vim.fn.bufname(of) .. ':' .. number + 1 .. ', typed: ' .. vim.trim(text))
    end
    local function place(uri, range)
        return vim.fn.fnamemodify(vim.uri_to_fname(uri), ':t') .. ':' .. range.start.line + 1 .. ':' .. range.start.character + 1
    end
    local function diagnostics(of, count)
        await(function() return #vim.diagnostic.get(of) == count end, count .. ' diagnostics of ' .. vim.fn.bufname(of))
        for _, one in ipairs(vim.diagnostic.get(of)) do
            say(('    %s:%d:%d %s [%s]'):format(vim.fn.bufname(of), one.lnum + 1, one.col + 1, one.message:match('^[^\n]*'), one.code))
        end
        return vim.diagnostic.get(of)
    end
    local function quote(words)
        words = vim.trim(words):gsub('%(%d+%.%d+ s%)', '(0.000 s)')
        for text in vim.gsplit(words, '\n', true) do say(text == '' and '' or '    ' .. text) end
    end
    -- Omits the keywords of the language, which have kind 14, because other documents list them.
    local function labels(items)
        local names = vim.tbl_filter(function(item) return item.kind ~= 14 end, items)
        return table.concat(vim.tbl_map(function(item) return item.label end, names), ' ') .. ', and words of the language'
    end
    local function run(lens)
        return ask('workspace/executeCommand', buffer, { command = lens.command.command, arguments = lens.command.arguments })
    end
    local function lenses(of)
        local all = {}
        for _, lens in ipairs(ask('textDocument/codeLens', of)) do
            local line = lens.range.start.line + 1
            all[line] = (all[line] and all[line] .. ' | ' or '') .. lens.command.title
        end
        return all, ask('textDocument/codeLens', of)
    end

    -- A PLC program
    local program_buffer = open('press.st')
    type_instead(program_buffer, 'Move :=', 'Move := Dely.Q;')
    diagnostics(program_buffer, 1)
    type_instead(program_buffer, 'Move :=', 'Move := Delay.Q;')
    diagnostics(program_buffer, 0)
    say('\nhover over START in press.st')
    quote(ask('textDocument/hover', program_buffer, at(program_buffer, '(START)', 'START')).contents.value)
    vim.cmd('buffer ' .. buffer)
    vim.cmd('bdelete! ' .. program_buffer)

    -- While a name is typed, in this file and in the included file
    type_instead(buffer, 'environment', '    environment Start = fre(OUT = START);')
    diagnostics(buffer, 1)
    local mistaken = at(buffer, 'environment', 'fre').position
    local fix = ask('textDocument/codeAction', buffer,
        { range = { start = mistaken, ['end'] = mistaken }, context = { diagnostics = {} } })[1]
    vim.lsp.util.apply_workspace_edit(fix.edit, 'utf-16')
    expect(lines(buffer)[6] == '    environment Start = free(OUT = START);', 'the quick fix mends it')
    say('    quick fix: ' .. fix.title)
    diagnostics(buffer, 0)
    type_instead(press_buffer, 'input', '    input START, GO;')
    diagnostics(buffer, 1)
    type_instead(press_buffer, 'input', '    input START;')
    diagnostics(buffer, 0)

    -- Names
    say('\nhover over MOVE in main.grafcet')
    quote(ask('textDocument/hover', buffer, at(buffer, 'never MOVE', 'MOVE')).contents.value)
    local definition = ask('textDocument/definition', buffer, at(buffer, 'X1', 'X1', 1))
    say('\ndefinition of X1: ' .. place(definition.uri, definition.range))
    local uses = ask('textDocument/references', buffer,
        vim.tbl_extend('error', at(buffer, 'X1', 'X1', 1), { context = { includeDeclaration = true } }))
    say('references: ' .. table.concat(vim.tbl_map(function(use) return place(use.uri, use.range) end, uses), ' '))
    type_instead(buffer, 'apart', '    property apart: never X')
    say('    offered: ' .. labels(ask('textDocument/completion', buffer, at(buffer, 'apart', 'X', 1)).items))
    type_instead(buffer, 'apart', '    property apart: never X0 && X1;')
    type_instead(press_buffer, 'step 1', '    step 1 { M')
    say('    offered: ' .. labels(ask('textDocument/completion', press_buffer, at(press_buffer, 'step 1', 'M', 1)).items))
    diagnostics(press_buffer, 1)
    type_instead(press_buffer, 'step 1', '    step 1 { MOVE; }')
    diagnostics(press_buffer, 0)
    vim.lsp.util.apply_workspace_edit(
        ask('textDocument/rename', buffer, vim.tbl_extend('error', at(buffer, 'X1', 'X1', 1), { newName = '7' })), 'utf-16')
    say('\nX1 renamed to 7')
    for _, of in ipairs({ buffer, press_buffer }) do
        for number, text in ipairs(lines(of)) do
            if text:find('7', 1, true) then say(('    %s:%d %s'):format(vim.fn.bufname(of), number, vim.trim(text))) end
        end
    end
    diagnostics(buffer, 0)

    -- Requests about the complete text
    local function outline(symbols, indent)
        for _, symbol in ipairs(symbols) do
            say(indent .. symbol.name .. (symbol.detail and symbol.detail ~= '' and ': ' .. symbol.detail or ''))
            outline(symbol.children or {}, indent .. '    ')
        end
    end
    say('\noutline of press.grafcet')
    outline(ask('textDocument/documentSymbol', press_buffer), '    ')
    for _, fold in ipairs(ask('textDocument/foldingRange', press_buffer)) do
        say(('folded: lines %d to %d'):format(fold.startLine + 1, fold.endLine + 1))
    end
    -- Neovim requests semantic tokens automatically only from version 0.9 on.
    local kinds = client.server_capabilities.semanticTokensProvider.legend.tokenTypes
    local tokens, line, character, words = ask('textDocument/semanticTokens/full', buffer).data, 0, 0, {}
    for first = 1, #tokens, 5 do
        if tokens[first] > 0 then character = 0 end
        line, character = line + tokens[first], character + tokens[first + 1]
        if line == 2 then
            table.insert(words, lines(buffer)[line + 1]:sub(character + 1, character + tokens[first + 2]) .. ' is a ' .. kinds[tokens[first + 3] + 1])
        end
    end
    say('colours of main.grafcet:3: ' .. table.concat(words, ', '))
    type_instead(buffer, 'controller', 'controller    press;')
    vim.lsp.util.apply_text_edits(ask('textDocument/formatting', buffer, { options = { tabSize = 4, insertSpaces = true } }),
        buffer, 'utf-16')
    expect(lines(buffer)[4] == '    controller press;', 'the text is formatted')
    diagnostics(buffer, 0)

    -- Verdicts
    vim.cmd('wall')
    say('\nsaved')
    local violated = diagnostics(buffer, 1)[1]
    for _, step in ipairs(violated.user_data.lsp.relatedInformation) do
        say('        ' .. place(step.location.uri, step.location.range) .. ' ' .. step.message)
    end
    local titles, all = lenses(buffer)
    say('lenses of main.grafcet')
    for number = 1, #lines(buffer) do
        if titles[number] then say(('    %d: %s'):format(number, titles[number])) end
    end
    say('a click on the last')
    quote(run(all[#all]).text)
    local _, of_chart = lenses(press_buffer)
    expect(of_chart[2].command.title == 'draw' and run(of_chart[2]).svg:find('<svg', 1, true), 'the chart is drawn')
    expect(all[2].command.title == 'simulate', 'there is a lens to simulate')
    local page = run(all[2]).uri
    expect(fetched(page, '/'):find('<html', 1, true), 'there is a page at ' .. page)
    expect(fetched(page, '/state'):find('main.grafcet', 1, true), 'the page is of the file')
    expect(#shown == 3, 'the verdict, the drawing and the page are shown')
    vim.api.nvim_buf_set_lines(buffer, 0, 0, true, { '' })
    diagnostics(buffer, 0)
    expect(select(1, lenses(buffer))[10]:find('not checked', 1, true), 'a change takes the verdict away')

    -- A change stops the checks of the previous text.
    local busy_buffer = open('busy.grafcet')
    await(function() return not working end, 'what was asked for is done')
    vim.cmd('write')
    await(function() return working end, 'the loop is checked')
    vim.api.nvim_buf_set_lines(busy_buffer, 0, 0, true, { '' })
    await(function() return not working end, 'the check is given up')
    expect(#vim.diagnostic.get(busy_buffer) == 0, 'nothing is told of what was not found out')

    client.stop()
    await(function() return client.is_stopped() end, 'the server ends')
    told:close()
    vim.cmd('qall!')
end

local fine, why = xpcall(session, debug.traceback)
if not fine then fail(why) end
