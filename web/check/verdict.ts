/** A verdict with all that is said beside it. */

import type { Engine } from "./engine";
import { element } from "./elements";
import { numbers } from "./numbers";
import type { Question, Suggestion, Verdict } from "./question";
import { formula } from "./typeset";

export type Apply = (suggestion: Suggestion) => void;

/** What is told of a verdict, part by part; parts that are the same are not made again. */
export class Details {
  #parts = new Map<string, { told: string; node: HTMLElement }>();

  constructor(
    private readonly box: HTMLElement,
    private readonly engine: Engine | null,
    private readonly question: Question | null,
    private readonly apply: Apply | null,
  ) {}

  show(verdict: Verdict): void {
    const isWrong = verdict.verdict === "differs" || verdict.verdict === "wrong_dimensions";
    const nodes = [
      this.#part("printed", [verdict.printed, verdict.printed_mathml], () => printed(verdict, isWrong)),
      isWrong && verdict.suggestions.length > 0
        ? this.#part("suggestions", verdict.suggestions, () => this.#suggestions(verdict))
        : null,
      this.#part("derived", verdict.derived, () => this.#derived(verdict)),
      isWrong && verdict.counterexample
        ? this.#part("numbers", verdict.counterexample.point, () => this.#numbers(verdict))
        : null,
      this.#part("said", [verdict.said, verdict.at_worst], () => said(verdict, isWrong)),
    ];
    this.box.replaceChildren(...nodes.filter((node): node is HTMLElement => node !== null));
  }

  #part(name: string, from: unknown, make: () => HTMLElement | null): HTMLElement | null {
    const told = JSON.stringify(from);
    const known = this.#parts.get(name);
    if (known?.told === told) return known.node;
    const node = make();
    if (node) this.#parts.set(name, { told, node });
    return node;
  }

  #derived(verdict: Verdict): HTMLElement | null {
    if (!verdict.derived || verdict.verdict === "equal") return null;
    return section("Derived", formula(verdict.derived_mathml, verdict.derived));
  }

  #numbers(verdict: Verdict): HTMLElement | null {
    const example = verdict.counterexample;
    if (!example || !this.engine || !this.question) return null;
    const entry = example.entry.length ? `, entry [${example.entry.join(", ")}]` : "";
    return section(
      `For example${entry}`,
      numbers(this.engine, this.question, example.point, example.entry),
    );
  }

  #suggestions(verdict: Verdict): HTMLElement {
    const items = verdict.suggestions.map((suggestion, place) => {
      const isName = suggestion.edit.startsWith("this is ");
      const entry = suggestion.entry.length ? `entry [${suggestion.entry.join(", ")}]: ` : "";
      const definition = suggestion.definition ? `the definition of ${suggestion.definition}: ` : "";
      const apply = this.apply;
      return element(
        "li",
        {},
        element("p", {}, `${entry}${definition}${suggestion.edit}${suggestion.proved ? "" : " (equal to 50 digits, not proved)"}`),
        isName ? null : formula(verdict.suggestions_mathml?.[place], suggestion.formula),
        apply && Object.keys(suggestion.applied).length > 0
          ? element("button", { type: "button", class: "apply", click: () => apply(suggestion) }, isName ? "Check against that" : "Put it in")
          : null,
      );
    });
    return section("Perhaps meant", element("ul", { class: "suggestions" }, ...items));
  }
}

function printed(verdict: Verdict, isWrong: boolean): HTMLElement | null {
  const box = formula(verdict.printed_mathml, verdict.printed);
  if (!verdict.printed) return null;
  if (isWrong) box.classList.add("wrong");
  return section("Read as", box);
}

function said(verdict: Verdict, isWrong: boolean): HTMLElement | null {
  const worst: [string, string][] = isWrong && verdict.at_worst ? [["at worst", verdict.at_worst]] : [];
  const items = [...worst, ...verdict.said].flatMap(([heading, text]) => [element("dt", {}, heading), element("dd", {}, text)]);
  return items.length ? element("dl", { class: "said" }, ...items) : null;
}

function section(title: string, ...content: (Node | null)[]): HTMLElement {
  return element("section", { class: "part" }, element("h3", {}, title), ...content);
}
