/** The quantities: what is searched while Python loads, and what is said of the one that is chosen. */

import type { Engine } from "./engine";
import { byId, element, settled } from "./elements";
import { formula, typeset } from "./typeset";

interface Entry {
  name: string;
  meaning: string;
  source: string;
  unit: string;
  conditioning: string;
  symbols: [string, string, string][];
  shape: number[];
  mathml: string;
}

const MOST = 60;

export class Catalogue {
  #entries: Entry[] = [];
  #shown: Entry[] = [];
  #active = -1;
  #asked = 0;
  readonly #input = byId<HTMLInputElement>("quantity");
  readonly #list = byId<HTMLUListElement>("quantities");

  constructor(private readonly engine: Engine) {
    const search = settled(120, () => void this.#search());
    this.#input.addEventListener("input", () => {
      search();
      this.tell();
    });
    this.#input.addEventListener("focus", () => void this.#search());
    this.#input.addEventListener("blur", () => window.setTimeout(() => this.#close(), 150));
    this.#input.addEventListener("keydown", (event) => this.#key(event));
  }

  async load(): Promise<void> {
    const response = await fetch("catalogue.json");
    this.#entries = (await response.json()) as Entry[];
    this.tell();
  }

  get value(): string {
    return this.#input.value.trim();
  }

  set value(name: string) {
    this.#input.value = name;
    this.#close();
    this.tell();
  }

  /** Search again, now that words of the field are known, too. */
  ready(): void {
    if (document.activeElement === this.#input) void this.#search();
  }

  /** Say what the chosen quantity is. */
  tell(): void {
    const known = this.#entries.find(({ name }) => name === this.value.replace(/\[.*$/s, ""));
    byId("meant").replaceChildren(...(known ? described(known) : []));
  }

  async #search(): Promise<void> {
    const words = this.value.toLowerCase();
    const asked = ++this.#asked;
    const parts = words.split(/\s+/).filter(Boolean);
    const text = (one: Entry): string => `${one.name} ${one.meaning} ${one.source}`.toLowerCase();
    this.#open(this.#entries.filter((one) => parts.every((part) => text(one).includes(part))));
    if (!parts.length || !this.engine.ready || this.#entries.some(({ name }) => name === words)) return;
    const { names } = await this.engine.ask<{ names?: string[] }>({ ask: "list", words });
    const isChoosing = this.#active >= 0; // what somebody is choosing from does not change
    if (asked !== this.#asked || isChoosing || !names?.length || document.activeElement !== this.#input) return;
    const found = names.map((name) => this.#entries.find((one) => one.name === name));
    this.#open(found.filter((one): one is Entry => one !== undefined));
  }

  #open(entries: Entry[]): void {
    this.#shown = entries.slice(0, MOST);
    this.#active = -1;
    const options = this.#shown.map((one, place) =>
      element(
        "li",
        { role: "option", id: `quantity-${place}`, "aria-selected": "false", mousedown: (event) => this.#choose(event, one) },
        element("span", { class: "option-name" }, one.name),
        element("span", { class: "option-meaning" }, one.meaning),
        typeset(one.mathml),
      ),
    );
    this.#list.replaceChildren(...options);
    const isOpen = options.length > 0 && document.activeElement === this.#input;
    this.#list.hidden = !isOpen;
    this.#input.setAttribute("aria-expanded", String(isOpen));
    this.#input.removeAttribute("aria-activedescendant");
  }

  #choose(event: Event, entry: Entry): void {
    event.preventDefault();
    this.value = entry.name;
  }

  #close(): void {
    this.#list.hidden = true;
    this.#input.setAttribute("aria-expanded", "false");
    this.#input.removeAttribute("aria-activedescendant");
  }

  #key(event: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step) {
      event.preventDefault();
      if (this.#list.hidden) void this.#search();
      else this.#move(step);
    } else if (event.key === "Enter" && !this.#list.hidden && this.#active >= 0) {
      event.preventDefault();
      this.value = this.#shown[this.#active]?.name ?? this.value;
    } else if (event.key === "Enter") {
      this.#close();
    } else if (event.key === "Escape" && !this.#list.hidden) {
      event.preventDefault();
      this.#close();
    }
  }

  #move(step: number): void {
    const options = [...this.#list.children];
    options[this.#active]?.setAttribute("aria-selected", "false");
    this.#active = (this.#active + step + options.length) % options.length;
    const option = options[this.#active];
    option?.setAttribute("aria-selected", "true");
    option?.scrollIntoView({ block: "nearest" });
    this.#input.setAttribute("aria-activedescendant", `quantity-${this.#active}`);
  }
}

function described(entry: Entry): Node[] {
  const symbols = entry.symbols.map(([name, meaning, unit]) =>
    element("li", {}, element("code", {}, name), ` ${meaning}${unit === "1" ? "" : `, ${unit}`}`),
  );
  return [
    element("p", {}, `${entry.meaning[0]?.toUpperCase() ?? ""}${entry.meaning.slice(1)}; ${entry.conditioning}.`),
    ...(entry.mathml ? [formula(entry.mathml, "")] : []),
    element(
      "details",
      {},
      element("summary", {}, "Its symbols"),
      element("ul", { class: "symbols" }, ...symbols),
      element("p", { class: "hint" }, `Unit ${entry.unit}. Source: ${entry.source}. `,
        element("a", { href: `../quantities/${entry.name}/` }, "Everything about it")),
    ),
  ];
}
