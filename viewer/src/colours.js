// SPDX-License-Identifier: GPL-3.0-or-later
// What a colour means: palettes for stitches, ramps and ranges for fields.

export const modes = [
    { key: "stitch", label: "stitch" },
    { key: "height", label: "height", unit: "length", diverging: true },
    { key: "mean", label: "mean curvature", unit: "1/length", diverging: true },
    { key: "gauss", label: "Gaussian curvature", unit: "1/length\u00b2", diverging: true },
    { key: "bending", label: "bending energy", unit: "energy/area", diverging: false },
    { key: "stretching", label: "stretching energy", unit: "energy/area", diverging: false },
];

// Knit and purl, then what stitches of the script's own take turns with.
const palettes = {
    paper: ["#c9463b", "#3f66b5", "#d9a441", "#4c9a75", "#8d62a8", "#7c7a76"],
    safe: ["#e69f00", "#0072b2", "#cc79a7", "#009e73", "#f0e442", "#7c7a76"],
};
const middle = "#f1ece3";
const ramps = {
    paper: ["#1d3f8a", "#5f86cc", middle, "#dd7a68", "#9c2018"],
    safe: ["#00436b", "#4a9bcf", middle, "#edb84a", "#a35c00"],
    sequential: ["#f6efdc", "#ecc07c", "#d3704f", "#8b3a62", "#31204f"],
};

export function stitchColour(id, safe) {
    const palette = safe ? palettes.safe : palettes.paper;
    return palette[id < 2 ? id : 2 + (id - 2) % (palette.length - 2)];
}

function rgb(hex) {
    return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}

export function rampOf(mode, safe) {
    return mode.diverging ? (safe ? ramps.safe : ramps.paper) : ramps.sequential;
}

// 256 colours of a ramp, as bytes RGB.
export function rampTable(mode, safe) {
    const stops = rampOf(mode, safe).map(rgb), table = new Uint8Array(3 * 256);
    for (let i = 0; i < 256; i++) {
        const at = i / 255 * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
        for (let c = 0; c < 3; c++)
            table[3 * i + c] = stops[k][c] + (at - k) * (stops[k + 1][c] - stops[k][c]);
    }
    return table;
}

// The range a field's colours span: 98 of 100 cells of the folded swatch, about
// zero where the sign matters; the rest takes the end's colour.
export function rangeOf(swatch, mode) {
    const last = swatch.fields[mode.key].slice(-swatch.cells);
    const sorted = (mode.diverging ? last.map(Math.abs) : last).sort();
    const most = sorted[Math.floor(0.98 * (sorted.length - 1))];
    const high = most > 0 ? most : 1;
    return { low: mode.diverging ? -high : 0, high };
}

export function stitchName(swatch, id) {
    return id === 0 ? "knit" : id === 1 ? "purl" : swatch.stitches[id].name;
}

// A number for people: three digits, a true minus.
export function number(value, digits = 3) {
    if (value === null || !Number.isFinite(value))
        return "\u2013";
    const text = Math.abs(value) < 1e-12 ? "0" : Number(value.toPrecision(digits)).toString();
    const [mantissa, exponent] = text.replace("-", "\u2212").split("e");
    return exponent ? `${mantissa}\u00b710${superscript(exponent)}` : mantissa;
}

function superscript(exponent) {
    const digits = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
    return exponent.replace("+", "").replace("-", "\u207b").replace(/\d/g, (d) => digits[d]);
}
