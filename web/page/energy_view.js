// SPDX-License-Identifier: MIT
// Where the energy of the strokes is or went, from the drum's ledger (docs/embedding.md).

const PARTS = [
  ["stored", "still in drum and sticks"],
  ["head_loss", "lost in the heads"],
  ["wire_loss", "lost in the wires"],
  ["contact_loss", "lost in contacts"],
  ["damper_loss", "lost in hands"],
  ["shell_loss", "lost in hoop, shell, air"],
  ["radiated", "radiated as sound"],
  ["removed", "left with the sticks"],
  ["taken", "taken by what was moved"],
];

/** Of what the strokes brought. Where controls took energy out, that went somewhere, too. */
function sharesOf(ledger) {
  const whole = ledger.injected + Math.max(ledger.control, 0);
  const parts = { ...ledger, taken: -ledger.control };
  return PARTS.map(([name]) => (whole > 0 ? Math.max(parts[name], 0) / whole : 0));
}

export class EnergyView {
  #bar;
  #rows = new Map(); // { piece, text }

  /** One bar of all parts, and a legend with a row for each. */
  constructor(bar, table) {
    this.#bar = bar;
    for (const [name, text] of PARTS) this.#rows.set(name, this.#addRow(table, name, text));
  }

  #addRow(table, name, title) {
    const row = table.insertRow();
    const head = document.createElement("th");
    head.scope = "row";
    const swatch = document.createElement("span");
    swatch.className = name;
    head.append(swatch, title);
    const text = document.createTextNode("");
    row.append(head);
    row.insertCell().append(text);
    const piece = document.createElement("span");
    piece.className = name;
    this.#bar.append(piece);
    return { piece, text };
  }

  /** Shows each part as a share, which together are 100 %. */
  show(ledger) {
    const shares = sharesOf(ledger);
    const words = PARTS.map(([name, title], i) => {
      const { piece, text } = this.#rows.get(name);
      piece.style.flexGrow = shares[i];
      text.data = `${(100 * shares[i]).toFixed(1)} %`;
      return `${title} ${text.data}`;
    });
    this.#bar.setAttribute("aria-label", words.join(", "));
  }
}
