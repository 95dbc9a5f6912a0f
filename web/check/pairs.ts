/** Fields for names with values: always one empty pair more than there are. */

import { element } from "./elements";

export class Pairs {
  readonly #rows: HTMLElement;

  constructor(
    box: HTMLElement,
    private readonly what: string,
    private readonly changed: () => void,
  ) {
    this.#rows = element("div", { class: "pairs" });
    box.append(this.#rows);
    this.value = {};
  }

  get value(): Record<string, string> {
    const rows = [...this.#rows.children].map((row) => [...row.querySelectorAll("input")].map((input) => input.value.trim()));
    return Object.fromEntries(rows.filter(([name, value]) => name && value)) as Record<string, string>;
  }

  set value(pairs: Record<string, string>) {
    this.#rows.replaceChildren(...Object.entries(pairs).map(([name, value]) => this.#row(name, value)), this.#row("", ""));
  }

  #row(name: string, value: string): HTMLElement {
    const typed = (): void => {
      const last = this.#rows.lastElementChild;
      if (last && [...last.querySelectorAll("input")].some((input) => input.value)) this.#rows.append(this.#row("", ""));
      this.changed();
    };
    const input = (what: string, text: string): HTMLElement =>
      element("input", { "aria-label": `${this.what}: ${what}`, value: text, spellcheck: "false", autocapitalize: "off", maxlength: "4000", input: typed });
    return element("div", { class: "pair" }, input("name", name), element("span", { "aria-hidden": "true" }, "="), input("value", value));
  }
}
