// SPDX-License-Identifier: GPL-3.0-or-later
// The stitch chart: the right side of the fabric on a canvas, numbered, with the
// marked stitch framed; knit is blank, purl a dot.
import { stitchColour } from "./colours.js";
import { stitchAt } from "./data.js";

const LEFT = 8, RIGHT = 30, TOP = 8, BOTTOM = 22;   // room for numbers, in pixels

// The step of numbers that keeps them `room` pixels apart.
function stride(size, room) {
    return [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000].find((n) => n * size >= room) ?? 10000;
}

export class Chart {
    constructor(holder, swatch) {
        this.swatch = swatch;
        this.holder = holder;
        this.canvas = document.createElement("canvas");
        this.frame = document.createElement("div");
        this.frame.className = "mark";
        this.frame.hidden = true;
        holder.append(this.canvas, this.frame);
        this.safe = false;
        new ResizeObserver(() => this.draw()).observe(holder);
    }

    // Stitches as wide as fits, as high as the gauge says; a high chart does not outgrow the window.
    measure() {
        const { columns, rows, width, height } = this.swatch;
        const room = this.holder.clientWidth - LEFT - RIGHT, most = Math.max(240, 0.8 * innerHeight);
        this.across = Math.max(1, Math.min(18, room / columns, most / rows * width / height));
        this.up = this.across * height / width;
    }

    draw() {
        const { columns, rows } = this.swatch, { canvas } = this;
        this.measure();
        const wide = Math.ceil(LEFT + columns * this.across + RIGHT), high = Math.ceil(TOP + rows * this.up + BOTTOM);
        const sharp = Math.min(devicePixelRatio, 8192 / Math.max(wide, high));
        canvas.width = wide * sharp;
        canvas.height = high * sharp;
        canvas.style.width = `${wide}px`;
        canvas.style.height = `${high}px`;
        const context = canvas.getContext("2d");
        context.scale(sharp, sharp);
        this.sharp = sharp;
        this.drawStitches(context);
        this.drawNumbers(context);
        this.setMark(this.marked);
    }

    drawStitches(context) {
        const { columns, rows, stitches } = this.swatch, { across, up } = this;
        const line = across >= 5 ? 0.75 : 0, sharp = (v) => Math.round(v * this.sharp) / this.sharp;     // no seams
        context.font = `${0.7 * Math.min(across, up)}px system-ui, sans-serif`;
        context.textAlign = "center";
        context.textBaseline = "middle";
        for (let row = 0; row < rows; row++)
            for (let column = 0; column < columns; column++) {
                const id = stitchAt(this.swatch, { column, row });
                const x = LEFT + column * across, y = TOP + (rows - 1 - row) * up;
                context.fillStyle = stitchColour(this.swatch, id, this.safe);
                context.fillRect(sharp(x), sharp(y), sharp(x + across) - sharp(x) - line, sharp(y + up) - sharp(y) - line);
                if (across >= 6 && id > 0)
                    this.drawSymbol(context, id, x + across / 2, y + up / 2, stitches[id].symbol);
            }
    }

    drawSymbol(context, id, x, y, symbol) {
        context.fillStyle = "rgba(255, 255, 255, 0.8)";
        if (id > 1) {
            context.fillText(symbol, x, y, this.across);
            return;
        }
        context.beginPath();
        context.arc(x, y, 0.14 * this.across, 0, 2 * Math.PI);
        context.fill();
    }

    drawNumbers(context) {
        const { columns, rows } = this.swatch, { across, up } = this;
        const rowStep = stride(up, 13), columnStep = stride(across, 24);
        context.font = "11px system-ui, sans-serif";
        context.fillStyle = getComputedStyle(this.holder).color;
        context.textAlign = "left";
        context.textBaseline = "middle";
        for (let row = rowStep; row <= rows; row += rowStep)
            context.fillText(row, LEFT + columns * across + 5, TOP + (rows - row + 0.5) * up);
        context.textAlign = "center";
        for (let column = columnStep; column <= columns; column += columnStep)
            context.fillText(column, LEFT + (column - 0.5) * across, TOP + rows * up + 11);
    }

    setColours(safe) {
        this.safe = safe;
        this.draw();
    }

    setMark(stitch) {
        this.marked = stitch;
        this.frame.hidden = !stitch;
        if (!stitch)
            return;
        const { style } = this.frame;
        style.left = `${this.canvas.offsetLeft + LEFT + stitch.column * this.across}px`;
        style.top = `${this.canvas.offsetTop + TOP + (this.swatch.rows - 1 - stitch.row) * this.up}px`;
        style.width = `${this.across}px`;
        style.height = `${this.up}px`;
    }

    // The stitch at a place on the screen, or null.
    pick(clientX, clientY) {
        const box = this.canvas.getBoundingClientRect(), { columns, rows } = this.swatch;
        const column = Math.floor((clientX - box.left - LEFT) / this.across);
        const row = rows - 1 - Math.floor((clientY - box.top - TOP) / this.up);
        return column >= 0 && column < columns && row >= 0 && row < rows ? { column, row } : null;
    }

    // Where the middle of a stitch is on the screen.
    place({ column, row }) {
        const box = this.canvas.getBoundingClientRect();
        return { x: box.left + LEFT + (column + 0.5) * this.across, y: box.top + TOP + (this.swatch.rows - row - 0.5) * this.up };
    }
}
