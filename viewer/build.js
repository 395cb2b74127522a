// SPDX-License-Identifier: GPL-3.0-or-later
// src/ in; one file without any reference to another out, in which output/page.c
// fills the lines @title@ and @data@.  node build.js OUT
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const src = join(dirname(fileURLToPath(import.meta.url)), "src");

async function bundle(entry) {
    const result = await build({
        entryPoints: [join(src, entry)],
        bundle: true,
        minify: true,
        write: false,
        format: "iife",
        target: ["es2020", "chrome90", "firefox90", "safari15"],
        charset: "ascii",
        lineLimit: 2000,
        legalComments: "inline",
        logLevel: "warning",
    });
    return result.outputFiles[0].text.trim();
}

const parts = {
    "@style@": await bundle("page.css"),
    "@script@": (await bundle("main.js")).replaceAll("</script", "<\\/script"),
};
const lines = readFileSync(join(src, "page.html"), "utf8").trimEnd().split("\n");
const page = lines.map((line) => parts[line.trim()] ?? line.replace(/^\s+(?=@)/, "")).join("\n") + "\n";
if (/[^\x00-\x7f]/.test(page))
    throw new Error("the page must be ASCII: write other characters as entities");
if (page.split("\n").filter((line) => line === "@title@" || line === "@data@").length !== 2)
    throw new Error("the page needs one line @title@ and one @data@");
writeFileSync(process.argv[2], page);
