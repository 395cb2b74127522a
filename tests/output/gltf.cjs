// SPDX-License-Identifier: GPL-3.0-or-later
// The Khronos validator's word on a glTF file: the validator's folder and the
// file in; its messages out, exit status 1 if there is any of them.
const fs = require("fs");
const [validator, path] = process.argv.slice(2);

require(validator)
    .validateBytes(new Uint8Array(fs.readFileSync(path)))
    .then((report) => {
        for (const m of report.issues.messages) console.log(`${m.code} ${m.pointer}: ${m.message}`);
        const { animationCount, hasMorphTargets, totalTriangleCount } = report.info;
        console.log(`animations ${animationCount}, morph ${hasMorphTargets}, triangles ${totalTriangleCount}`);
        process.exitCode = report.issues.messages.length > 0 ? 1 : 0;
    });
