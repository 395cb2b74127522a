-- SPDX-License-Identifier: GPL-3.0-or-later
-- From Markdown to a page: links between chapters, tables that may scroll, a
-- list of sections on long pages, and pictures of motifs for text charts.
local motif, sections, pictures = nil, {}, nil

local function exists(path)
    local file = io.open(path)
    if file then file:close() end
    return file ~= nil
end

function Meta(meta)
    pictures = meta.pictures and pandoc.utils.stringify(meta.pictures)
end

-- Chapters are pages here; other files of the source tree are not beside them.
function Link(link)
    local path, place = link.target:match("^([%w_-]+)%.md(#?.*)$")
    if path then
        link.target = path .. ".html" .. place
    elseif link.target:match("^%.%.?/") then
        return link.content
    end
    return link
end

local function image(file, alt)
    return exists(pictures .. "/" .. file) and pandoc.Image(alt, "stitches/" .. file) or nil
end

-- The drawn chart in place of the letters, and the fold beside it.
local function motif_parts(block)
    local chart, fold = image(motif .. ".svg", "Chart of " .. motif), image(motif .. ".png", "Fold of " .. motif)
    local parts = {chart and pandoc.Para(chart) or block}
    if fold then table.insert(parts, pandoc.Para(fold)) end
    return pandoc.Div(parts, {class = "motif"})
end

local function rewrite(block)
    if block.t == "Header" and block.level == 2 then
        motif = pandoc.utils.stringify(block)
        table.insert(sections, {pandoc.Plain(pandoc.Link(block.content, "#" .. block.identifier))})
    elseif block.t == "Table" then
        return pandoc.Div(block, {class = "table"})
    elseif block.t == "CodeBlock" and block.classes:includes("chart") and pictures then
        return motif_parts(block)
    end
    return block
end

-- Behind the title, the sections of a chapter that has many.
function Pandoc(doc)
    local place
    for i, block in ipairs(doc.blocks) do
        if not place and block.t == "Header" and block.level == 2 then place = i end
        doc.blocks[i] = rewrite(block)
    end
    if #sections > 4 then
        doc.blocks:insert(place, pandoc.Div(pandoc.BulletList(sections), {class = "contents"}))
    end
    return doc
end

return {{Meta = Meta}, {Link = Link}, {Pandoc = Pandoc}}
