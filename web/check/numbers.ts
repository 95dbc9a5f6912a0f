/** Both formulas at a point, whose numbers can be changed. */

import type { Engine } from "./engine";
import { element, settled } from "./elements";
import type { Failure, Question, Symbol, Values } from "./question";
import { typeset } from "./typeset";

const DEGREE = Math.PI / 180;

/** A table of the symbols with their numbers, and what both formulas are worth there. */
export function numbers(engine: Engine, question: Question, first: Record<string, number>, entry: number[]): HTMLElement {
  const point = { ...first };
  const compared = element("p", { class: "compared", "aria-live": "polite" });
  const rows = element("div", { class: "numbers" });
  const evaluate = async (): Promise<void> => {
    const values = await engine
      .ask<Values | Failure>({ ask: "values", ...question, point, entry })
      .catch((): Failure => ({ error: "The numbers could not be computed in time." }));
    if ("error" in values) {
      compared.textContent = values.error;
      return;
    }
    if (!rows.childElementCount) rows.append(...values.symbols.map((symbol) => field(symbol, point, changed)));
    compared.replaceChildren(...told(values));
  };
  const changed = settled(150, () => void evaluate());
  void evaluate();
  return element("div", {}, rows, compared);
}

function field(symbol: Symbol, point: Record<string, number>, changed: () => void): HTMLElement {
  const isAngle = symbol.unit === "rad";
  const scale = isAngle ? DEGREE : 1;
  const unit = isAngle ? "°" : symbol.unit === "1" ? "" : symbol.unit;
  const input = element("input", {
    inputmode: "decimal",
    value: written(symbol.value / scale),
    title: `${symbol.meaning}, from ${written(symbol.low / scale)} to ${written(symbol.high / scale)} ${unit}`.trim(),
    input: () => {
      const number = Number(input.value.replace(",", ".").replace("−", "-"));
      const isNumber = input.value.trim() !== "" && Number.isFinite(number);
      input.setAttribute("aria-invalid", String(!isNumber));
      if (!isNumber) return;
      point[symbol.name] = number * scale;
      changed();
    },
  });
  const name = element("span", { class: "symbol" });
  name.append(typeset(symbol.mathml) ?? symbol.name);
  return element("label", {}, name, " = ", input, ` ${unit} `, element("span", { class: "hint" }, symbol.meaning));
}

function told({ printed, derived, relative_difference: relative }: Values): Node[] {
  const side = (name: string, value: number | null): Node =>
    element("span", {}, `${name} `, element("strong", {}, value === null ? "not a real number" : written(value)));
  const parts: Node[] = [side("printed", printed), side("derived", derived)];
  if (relative !== null) parts.push(element("span", { class: relative > 1e-12 ? "bad" : "good" }, apart(relative)));
  return parts;
}

function apart(relative: number): string {
  if (relative <= 1e-12) return "the same";
  if (relative > 1e4) return `a factor of ${relative.toExponential(1)}`;
  return `relative difference ${Number((100 * relative).toPrecision(3))} %`;
}

/** Six digits, as people write them. */
export function written(value: number): string {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) return Number(value.toPrecision(6)).toExponential().replace("e+", "e");
  return String(Number(value.toPrecision(6)));
}
