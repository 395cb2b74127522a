// SPDX-License-Identifier: GPL-3.0-or-later
// What a page says in words and figures: the result, energies at a time of the
// growth with their curve, parameters, the stitch under the pointer.
import { modesOf, number, stitchName } from "./colours.js";
import { atStitch, stitchAt } from "./data.js";

const parts = ["total", "bending", "stretching", "springs"];

export function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value);
    made.append(...children);
    return made;
}

const endings = {
    converged: "converged",
    precision: "converged to the precision of the arithmetic",
    saddle: "not converged: a saddle, not a minimum",
    iteration_limit: "not converged: the limit of iterations was reached",
};

export function summary({ columns, rows, result, steps, every }) {
    const percent = (share) => `${number(100 * share)} %`;
    const thinned = every > 1 && `one growth step in ${every} is shown`;
    const size = `${columns} stitches \u00d7 ${rows} rows`;
    if (result.status === "stopped")
        return [size, [`stopped after ${percent(steps.at(-1).growth)} of the growth`, thinned].filter(Boolean).join("; ")];
    const words = `${size}, folded to ${percent(result.extent_x)} of the width and ` +
        `${percent(result.extent_y)} of the height, ${number(result.extent_z)} deep`;
    const ending = endings[result.status] ?? result.status;
    return [words, [ending, result.remark, thinned].filter(Boolean).join("; ")];
}

// ---- energies ----

function energyAt(swatch, part, time) {
    const step = Math.min(Math.floor(time), swatch.nsteps - 1), next = Math.min(step + 1, swatch.nsteps - 1);
    return swatch.steps[step][part] + (time - step) * (swatch.steps[next][part] - swatch.steps[step][part]);
}

export function growthAt(swatch, time) {
    return energyAt(swatch, "growth", time);
}

const WIDE = 260, HIGH = 72;

// Energy over growth; the dot is where the slider stands.
function curve(swatch) {
    const most = Math.max(...swatch.steps.map((step) => step.total)) || 1;
    const place = (time) => {
        const x = 4 + (WIDE - 8) * growthAt(swatch, time);
        return [x, HIGH - 6 - (HIGH - 14) * energyAt(swatch, "total", time) / most];
    };
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.setAttribute("viewBox", `0 0 ${WIDE} ${HIGH}`);
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", "energy over growth");
    const points = swatch.steps.map((_, step) => place(step).map((v) => v.toFixed(1)).join(",")).join(" ");
    svg.innerHTML = `<line x1="4" x2="${WIDE - 4}" y1="${HIGH - 6}" y2="${HIGH - 6}"/><polyline points="${points}"/><circle r="4"/>`;
    const dot = svg.querySelector("circle");
    return { svg, move(time) {
        const [x, y] = place(time);
        dot.setAttribute("cx", x.toFixed(1));
        dot.setAttribute("cy", y.toFixed(1));
    } };
}

// Fills the holder; the function it returns shows a time.
export function energies(holder, swatch) {
    const shown = parts.filter((part) => part !== "springs" || swatch.steps.some((step) => step.springs !== 0));
    const cells = {}, body = element("tbody"), drawn = curve(swatch);
    for (const part of shown) {
        cells[part] = element("td");
        body.append(element("tr", { class: part }, element("th", { scope: "row" }, part), cells[part]));
    }
    holder.append(drawn.svg, element("table", {}, body));
    const error = swatch.result.error_estimate;
    if (error !== null)
        holder.append(element("p", { class: "aside" }, `error of the final energy: about ${number(100 * error, 2)} %`));
    return (time) => {
        drawn.move(time);
        for (const part of shown)
            cells[part].textContent = number(energyAt(swatch, part, time), 5);
    };
}

// ---- parameters ----

export function parameters(holder, swatch) {
    const body = element("tbody");
    for (const { name, value, unit, from, about } of swatch.parameters) {
        const text = typeof value === "number" ? number(value, 6) : value;
        body.append(element("tr", { class: from.replace(" ", "-"), title: [about, `from: ${from}`].filter(Boolean).join("; ") },
            element("th", { scope: "row" }, name), element("td", {}, String(text ?? "\u2013")), element("td", {}, unit)));
    }
    holder.append(element("table", {}, body), element("p", { class: "aside" }, "faint: a default the script leaves as it is"));
}

// ---- the stitch under the pointer ----

export function readout(swatch, stitch, time) {
    const name = stitchName(swatch, stitchAt(swatch, stitch));
    const values = modesOf(swatch).slice(1).map((mode) => `${mode.label} ${number(atStitch(swatch, mode.name, time, stitch), 2)}`);
    return { head: `row ${stitch.row + 1}, column ${stitch.column + 1}: ${name}`, values };
}
