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
];

export class EnergyView {
  #rows = new Map(); // { meter, text }

  constructor(table) {
    for (const [name, text] of PARTS) this.#rows.set(name, this.#addRow(table, text));
  }

  #addRow(table, title) {
    const row = table.insertRow();
    const head = document.createElement("th");
    head.scope = "row";
    head.textContent = title;
    const meter = document.createElement("meter");
    meter.setAttribute("aria-label", title);
    const text = document.createTextNode("");
    row.append(head);
    row.insertCell().append(meter);
    row.insertCell().append(text);
    return { meter, text };
  }

  /** Shows each part as a share of what the strokes brought. */
  show(ledger) {
    const whole = ledger.injected + Math.max(ledger.control, 0);
    for (const [name, { meter, text }] of this.#rows) {
      const share = whole > 0 ? Math.max(ledger[name] / whole, 0) : 0;
      meter.value = Math.min(share, 1);
      text.data = `${(100 * share).toFixed(1)} %`;
    }
  }
}
