// SPDX-License-Identifier: GPL-3.0-or-later
// The text in <script id="weft-data"> in, a swatch with its fields out; the
// counterpart of output/page_pack.c.
import { unzlibSync } from "fflate";

const LEVELS = 65535;

function fromBase64(text) {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; i++)
        bytes[i] = binary.charCodeAt(i);
    return bytes;
}

// One field over all steps: undoes planes, sign folding, prediction, quantisation.
function unpack(bytes, at, { width, height, low, high }, nlayers) {
    const n = width * height * nlayers;
    const values = new Float32Array(n), below = new Uint16Array(width);
    const quantum = (high - low) / LEVELS;
    for (let row = 0, i = 0; row < height * nlayers; row++) {
        let left = 0, between = 0;
        if (row % height === 0)
            below.fill(0);
        for (let x = 0; x < width; x++, i++) {
            const folded = bytes[at + i] | bytes[at + n + i] << 8;
            const rest = folded >> 1 ^ -(folded & 1);
            const level = rest + left + below[x] - between & 0xffff;
            between = below[x];
            left = below[x] = level;
            values[i] = low + level * quantum;
        }
    }
    return values;
}

// Takes its mean off each run of n values.
function centre(values, n) {
    for (let at = 0; at < values.length; at += n) {
        let sum = 0;
        for (let i = at; i < at + n; i++)
            sum += values[i];
        for (let i = at; i < at + n; i++)
            values[i] -= sum / n;
    }
    return values;
}

// Height over the middle, at cells as the other fields.
function heights({ fields, nx, ny, points, cells, nsteps }) {
    const height = new Float32Array(cells * nsteps), across = nx + 1;
    for (let step = 0, i = 0; step < nsteps; step++)
        for (let y = 0; y < ny; y++)
            for (let x = 0; x < nx; x++, i++) {
                const a = step * points + y * across + x;
                height[i] = (fields.z[a] + fields.z[a + 1] + fields.z[a + across] + fields.z[a + across + 1]) / 4;
            }
    return centre(height, cells);
}

export function readSwatch(text) {
    const { blob, fields: listed, ...swatch } = JSON.parse(text);
    const bytes = unzlibSync(fromBase64(blob));
    swatch.nsteps = swatch.steps.length;
    swatch.nx = swatch.columns * swatch.per_stitch;
    swatch.ny = swatch.rows * swatch.per_stitch;
    swatch.points = (swatch.nx + 1) * (swatch.ny + 1);
    swatch.cells = swatch.nx * swatch.ny;
    let at = swatch.columns * swatch.rows;
    swatch.grid = bytes.subarray(0, at);
    swatch.fields = {};
    for (const field of listed) {
        swatch.fields[field.name] = unpack(bytes, at, field, swatch.nsteps);
        at += 2 * field.width * field.height * swatch.nsteps;
    }
    for (const axis of ["x", "y", "z"])     // so that the swatch stays in place
        centre(swatch.fields[axis], swatch.points);
    swatch.fields.height = heights(swatch);
    return swatch;
}

// The field at a time between two steps, into `into` ((n), every stride-th from `from` on).
export function between(values, n, time, into, from = 0, stride = 1) {
    const step = Math.min(Math.floor(time), values.length / n - 1), next = Math.min(step + 1, values.length / n - 1);
    const share = time - step, a = step * n, b = next * n;
    for (let i = 0, k = from; i < n; i++, k += stride)
        into[k] = values[a + i] + share * (values[b + i] - values[a + i]);
}

// A field's mean over a stitch.
export function atStitch(swatch, name, time, { column, row }) {
    const { nx, cells, per_stitch, nsteps } = swatch, values = swatch.fields[name];
    const step = Math.min(Math.floor(time), nsteps - 1), next = Math.min(step + 1, nsteps - 1), share = time - step;
    let sum = 0;
    for (let y = row * per_stitch; y < (row + 1) * per_stitch; y++)
        for (let x = column * per_stitch; x < (column + 1) * per_stitch; x++) {
            const i = y * nx + x;
            sum += (1 - share) * values[step * cells + i] + share * values[next * cells + i];
        }
    return sum / per_stitch ** 2;
}

export function stitchAt(swatch, { column, row }) {
    return swatch.grid[row * swatch.columns + column];
}
