/** The formula as it is typed: as text, or in MathLive, which writes LaTeX. */

import { byId } from "./elements";
import { looksLike, type Notation } from "./question";

interface MathField extends HTMLElement {
  value: string;
  mathVirtualKeyboardPolicy: string;
}

export class FormulaField {
  readonly #text = byId<HTMLTextAreaElement>("formula");
  readonly #notation = byId<HTMLSelectElement>("notation");
  readonly #button = byId<HTMLButtonElement>("editor-button");
  readonly #editor = byId("editor");
  #field: MathField | null = null;

  constructor(private readonly changed: () => void) {
    this.#text.addEventListener("input", changed);
    this.#notation.addEventListener("change", changed);
    this.#button.addEventListener("click", () => void this.#toggle());
  }

  get value(): string {
    return this.#text.value.trim();
  }

  get notation(): Notation {
    return (this.#notation.value as Notation) || looksLike(this.value);
  }

  set(formula: string, notation: Notation): void {
    this.#text.value = formula;
    this.#notation.value = looksLike(formula) === notation ? "" : notation;
    if (this.#field && !this.#editor.hidden) this.#field.value = notation === "latex" ? formula : "";
    this.changed();
  }

  /** Show where the fault is. */
  point(from: number, to: number): void {
    if (!this.#editor.hidden) return;
    const lead = this.#text.value.length - this.#text.value.trimStart().length;
    this.#text.focus();
    this.#text.setSelectionRange(from + lead, Math.max(to, from + 1) + lead);
  }

  async #toggle(): Promise<void> {
    const isOpen = this.#editor.hidden;
    if (isOpen && !this.#field) await this.#load();
    this.#editor.hidden = !isOpen;
    this.#button.setAttribute("aria-pressed", String(isOpen));
    if (!isOpen || !this.#field) {
      this.#text.focus();
      return;
    }
    this.#field.value = this.notation === "latex" ? this.value : "";
    this.#field.focus();
  }

  async #load(): Promise<void> {
    const { MathfieldElement } = await import("mathlive");
    MathfieldElement.fontsDirectory = new URL("fonts", document.baseURI).href;
    MathfieldElement.soundsDirectory = null;
    MathfieldElement.plonkSound = null;
    const field = new MathfieldElement() as unknown as MathField;
    field.setAttribute("aria-labelledby", "formula-label");
    field.mathVirtualKeyboardPolicy = "auto";
    field.addEventListener("input", () => {
      this.#text.value = field.value;
      this.#notation.value = "latex";
      this.changed();
    });
    this.#editor.append(field);
    this.#field = field;
  }
}
