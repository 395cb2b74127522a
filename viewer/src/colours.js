// SPDX-License-Identifier: GPL-3.0-or-later
// What a colour means: the palettes, scales and ranges that come with the
// swatch, the same as in weft's pictures.

// What the fold can be coloured by: its stitches, or a field with its scale.
export function modesOf(swatch) {
    const fields = swatch.colorings.map((field) => ({ ...field, label: field.title.split(" (")[0] }));
    return [{ name: "stitch", label: "stitch" }, ...fields];
}

export function stitchColour(swatch, id, safe) {
    return swatch.palettes[safe ? "safe" : "paper"][id];
}

// 256 colours of a mode's scale, as bytes RGB.
export function scaleTable(swatch, mode) {
    const stops = swatch.scales[mode.scale].map((hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16)));
    const table = new Uint8Array(3 * 256);
    for (let i = 0; i < 256; i++) {
        const at = i / 255 * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
        for (let c = 0; c < 3; c++)
            table[3 * i + c] = Math.round(stops[k][c] + (at - k) * (stops[k + 1][c] - stops[k][c]));
    }
    return table;
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
